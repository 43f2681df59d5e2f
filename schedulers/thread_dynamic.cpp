#include "schedulers/builtin.h"
#include "schedulers/thread_pool.h"
#include "schedulers/work.h"

namespace raysweep {

namespace {

/// Workers take the next chunk from a shared counter when they are free.
class ThreadDynamic final : public Scheduler {
 public:
  explicit ThreadDynamic(const SchedulerOptions& options) : pool_(options) {}

 private:
  void run_items(const ItemSpace& items, const Chunk& chunk, const Work& work) override {
    const size_t size = chunk.size(items, pool_.threads());
    SharedCounter next;
    pool_.run([&](int worker) {
      // Relaxed: only the numbers must differ; the pool orders everything before and after the run.
      for (size_t begin; (begin = next.value.fetch_add(size, std::memory_order_relaxed)) < items.count;) {
        work(begin, std::min(begin + size, items.count), worker);
      }
    });
  }

  ThreadPool pool_;
};

}  // namespace

std::unique_ptr<Scheduler> make_thread_dynamic(const SchedulerOptions& options) {
  return std::make_unique<ThreadDynamic>(options);
}

}  // namespace raysweep
