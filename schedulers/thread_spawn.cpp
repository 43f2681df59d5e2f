#include <thread>
#include <vector>

#include "schedulers/binding.h"
#include "schedulers/builtin.h"
#include "schedulers/work.h"

namespace raysweep {

namespace {

/// Threads created anew for every run, one contiguous block each, while the caller waits (the 2022 course
/// work). The only scheduler whose thread creation is timed.
class ThreadSpawn final : public Scheduler {
 public:
  explicit ThreadSpawn(const SchedulerOptions& options)
      : threads_(static_cast<size_t>(options.threads)), binding_(options.processors) {}

 private:
  void run_items(const ItemSpace& items, const Chunk&, const Work& work) override {
    std::vector<std::jthread> workers;  // joined on the way out, also when a thread cannot be made
    workers.reserve(threads_);
    for (size_t part = 0; part < threads_; ++part) {
      const size_t begin = block_begin(items.count, part, threads_),
                   end = block_begin(items.count, part + 1, threads_);
      if (begin == end) continue;
      workers.emplace_back([this, &work, begin, end, part] {
        const int worker = static_cast<int>(part);
        binding_.bind(worker);
        work(begin, end, worker);
      });
    }
  }

  size_t threads_;
  Binding binding_;
};

}  // namespace

std::unique_ptr<Scheduler> make_thread_spawn(const SchedulerOptions& options) {
  return std::make_unique<ThreadSpawn>(options);
}

}  // namespace raysweep
