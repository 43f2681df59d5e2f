// Threads that stay, asleep between runs.
#pragma once

#include <atomic>
#include <functional>
#include <thread>
#include <vector>

#include "schedulers/binding.h"
#include "schedulers/options.h"

namespace raysweep {

/// A number that several workers count up, alone in its cache lines: what they only read must not lie beside
/// it.
struct alignas(128) SharedCounter {
  std::atomic<size_t> value{0};
};

/// `threads` workers, of which worker 0 is whoever calls `run`.
class ThreadPool {
 public:
  explicit ThreadPool(const SchedulerOptions& options);
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
  template <class Ready>
  void spin_until(Ready ready) const;

  const long long spin_count_;
  const Binding binding_;
  const BoundCaller caller_;
  alignas(128) std::atomic<unsigned> round_{0};  // counts runs; helpers sleep on it
  alignas(128) std::atomic<int> busy_{0};        // helpers still at work; the caller sleeps on it
  alignas(128) std::atomic<bool> stopping_{false};
  const std::function<void(int)>* work_ = nullptr;
  std::vector<std::thread> helpers_;
};

}  // namespace raysweep
