// Threads that stay, asleep between runs.
#pragma once

#include <atomic>
#include <functional>
#include <thread>
#include <vector>

namespace raysweep {

/// `threads` workers, of which worker 0 is whoever calls `run`.
class ThreadPool {
 public:
  explicit ThreadPool(int threads);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  [[nodiscard]] int threads() const { return static_cast<int>(helpers_.size()) + 1; }

  /// Calls `work(worker)` once on every worker and returns when all calls have returned. `work` must not
  /// throw.
  void run(const std::function<void(int worker)>& work);

 private:
  void serve(int worker);
  void stop() noexcept;

  std::atomic<unsigned> round_{0};  // counts runs; helpers sleep on it
  std::atomic<int> busy_{0};        // helpers still at work; the caller sleeps on it
  std::atomic<bool> stopping_{false};
  const std::function<void(int)>* work_ = nullptr;
  std::vector<std::thread> helpers_;
};

}  // namespace raysweep
