#include "schedulers/scheduler.h"

#include <sched.h>

#include <atomic>
#include <exception>
#include <mutex>

namespace raysweep {

namespace {

/// The first of several errors from several threads.
class FirstError {
 public:
  void capture() noexcept {
    const std::scoped_lock lock(mutex_);
    if (!error_) error_ = std::current_exception();
    // Relaxed: the flag only saves work; the error itself is read after all workers have been joined.
    raised_.store(true, std::memory_order_relaxed);
  }
  [[nodiscard]] bool raised() const noexcept { return raised_.load(std::memory_order_relaxed); }
  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  std::atomic<bool> raised_{false};
  std::mutex mutex_;
  std::exception_ptr error_;
};

}  // namespace

void WorkerLog::ran(int worker, size_t begin, size_t end, bool joined) {
  WorkerEntry& entry = entries_[static_cast<size_t>(worker)];
  if (entry.chunks == 0) entry.processor = sched_getcpu();
  entry.items += end - begin;
  if (!joined || begin == 0 || begin != entry.last_end) entry.chunks++;
  entry.last_end = end;
}

int WorkerLog::workers_seen() const {
  return static_cast<int>(std::ranges::count_if(entries_, [](const WorkerEntry& e) { return e.items > 0; }));
}

void Scheduler::run(const ItemSpace& items, const Chunk& chunk, const Body& body, WorkerLog& log) {
  if (items.count == 0) return;
  FirstError error;
  const bool joined = calls_by_item();
  const Body guarded = [&](size_t begin, size_t end, int worker) noexcept {
    if (error.raised()) return;
    try {
      log.ran(worker, begin, end, joined);
      body(begin, end, worker);
    } catch (...) {
      error.capture();
    }
  };
  run_items(items, chunk, guarded);
  error.rethrow();
}

}  // namespace raysweep
