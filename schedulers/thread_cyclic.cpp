#include "schedulers/builtin.h"
#include "schedulers/thread_pool.h"
#include "schedulers/work.h"

namespace raysweep {

namespace {

/// Chunks dealt round robin: worker w takes chunks w, w + threads, w + 2·threads, …
class ThreadCyclic final : public Scheduler {
 public:
  explicit ThreadCyclic(const SchedulerOptions& options) : pool_(options) {}

 private:
  void run_items(const ItemSpace& items, const Chunk& chunk, const Work& work) override {
    const size_t size = chunk.size(items, pool_.threads());
    const size_t stride = size * static_cast<size_t>(pool_.threads());
    pool_.run([&](int worker) {
      for (size_t begin = size * static_cast<size_t>(worker); begin < items.count; begin += stride) {
        work(begin, std::min(begin + size, items.count), worker);
      }
    });
  }

  ThreadPool pool_;
};

}  // namespace

std::unique_ptr<Scheduler> make_thread_cyclic(const SchedulerOptions& options) {
  return std::make_unique<ThreadCyclic>(options);
}

}  // namespace raysweep
