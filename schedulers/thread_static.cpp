#include "schedulers/builtin.h"
#include "schedulers/thread_pool.h"
#include "schedulers/work.h"

namespace raysweep {

namespace {

/// One contiguous block for each worker.
class ThreadStatic final : public Scheduler {
 public:
  explicit ThreadStatic(const SchedulerOptions& options) : pool_(options) {}

 private:
  void run_items(const ItemSpace& items, const Chunk&, const Work& work) override {
    const auto parts = static_cast<size_t>(pool_.threads());
    pool_.run([&](int worker) {
      const auto part = static_cast<size_t>(worker);
      const size_t begin = block_begin(items.count, part, parts),
                   end = block_begin(items.count, part + 1, parts);
      if (begin < end) work(begin, end, worker);
    });
  }

  ThreadPool pool_;
};

}  // namespace

std::unique_ptr<Scheduler> make_thread_static(const SchedulerOptions& options) {
  return std::make_unique<ThreadStatic>(options);
}

}  // namespace raysweep
