// Work that a few threads share by a counter: as little of a scheduler as there can be.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace raysweep {

/// `threads` threads, the one that calls `run` (worker 0) among them; the others wait between runs.
class WorkTeam {
 public:
  using Body = std::function<void(size_t i, size_t worker)>;

  explicit WorkTeam(int threads);
  ~WorkTeam();
  WorkTeam(const WorkTeam&) = delete;
  WorkTeam& operator=(const WorkTeam&) = delete;

  /// Calls `body(i, worker)` once for each `i` below `count`. What the bodies have written is there
  /// afterwards. The first error is rethrown when all have stopped; what was not begun by then is left out.
  /// Not from within a body.
  void run(size_t count, const Body& body);

 private:
  struct Run {
    const Body* body = nullptr;  // none: nobody may join
    size_t count = 0, number = 0;
  };

  void end();
  void serve(size_t worker);
  void take_items(const Run& run, size_t worker);

  std::mutex mutex_;  // for all but next_
  std::condition_variable wake_, left_;
  Run run_;
  size_t inside_ = 0;  // other threads that have joined the run
  bool ends_ = false;
  std::exception_ptr error_;
  std::atomic<size_t> next_{0};
  std::vector<std::jthread> others_;
};

/// One run of a team that lives as long as that takes.
void share_work(int threads, size_t count, const WorkTeam::Body& body);

}  // namespace raysweep
