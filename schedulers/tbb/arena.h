// What all schedulers on TBB share: an arena of their own, as large as asked for, its threads bound.
#pragma once

#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <tbb/task_scheduler_observer.h>

#include <atomic>
#include <memory>
#include <thread>

#include "schedulers/binding.h"
#include "schedulers/options.h"
#include "schedulers/scheduler.h"
#include "schedulers/work.h"

namespace raysweep {

/// Binds each thread while it is in the arena, as the worker whose slot it has. Called for the thread that
/// calls `execute` too, so whoever leaves gets back the processors that the maker of this object had. TBB's
/// threads outlive the arena, and it tells nobody of those that leave after `observe(false)`: they are waited
/// for, lest one come bound to the next arena. They leave within microseconds once there is nothing to do.
/// One that comes while this ends is not bound any more.
class BindingObserver final : public tbb::task_scheduler_observer {
 public:
  BindingObserver(tbb::task_arena& arena, const Binding& binding)
      : tbb::task_scheduler_observer(arena), binding_(binding), before_(allowed_processors()) {
    observe(!binding_.none());
  }
  ~BindingObserver() override {
    ends_.store(true);
    while (inside_.load() > 0) std::this_thread::yield();
    observe(false);
  }
  BindingObserver(const BindingObserver&) = delete;
  BindingObserver& operator=(const BindingObserver&) = delete;

  void on_scheduler_entry(bool) override {
    inside_.fetch_add(1);
    if (!ends_.load()) binding_.bind(tbb::this_task_arena::current_thread_index());
  }
  void on_scheduler_exit(bool) override {
    (void)bind_this_thread(before_);
    inside_.fetch_sub(1);
  }

 private:
  const Binding& binding_;
  ProcessorSet before_;
  // In one order for all threads (sequentially consistent): whoever comes sees that this ends, or the end
  // sees who has come.
  std::atomic<bool> ends_{false};
  std::atomic<int> inside_{0};  // threads that have come and not left
};

class TbbScheduler : public Scheduler {
 public:
  explicit TbbScheduler(const SchedulerOptions& options)
      : limit_(tbb::global_control::max_allowed_parallelism, static_cast<size_t>(options.threads)),
        arena_(options.threads),
        binding_(options.processors),
        observer_(arena_, binding_) {}

 protected:
  [[nodiscard]] int threads() const { return arena_.max_concurrency(); }
  [[nodiscard]] static int this_worker() { return tbb::this_task_arena::current_thread_index(); }

 private:
  virtual void run_inside(const ItemSpace& items, const Chunk& chunk, const Work& work) = 0;

  void run_items(const ItemSpace& items, const Chunk& chunk, const Work& work) final {
    work.before_all();
    arena_.execute([&] { run_inside(items, chunk, work); });
    work.after_all();
  }

  // Both are needed: the control alone leaves the arena at the processors' count, the arena alone starts no
  // more workers than there are processors.
  tbb::global_control limit_;
  tbb::task_arena arena_;
  Binding binding_;
  BindingObserver observer_;
};

template <class S>
std::unique_ptr<Scheduler> make_tbb(const SchedulerOptions& options) {
  return std::make_unique<S>(options);
}

}  // namespace raysweep
