#include "schedulers/builtin.h"
#include "schedulers/thread_pool.h"
#include "schedulers/work.h"

namespace raysweep {

namespace {

/// As thread_dynamic, but each chunk is half a fair share of what is left, and never less than asked: large
/// chunks first, small ones to even out the end. The half guards against a first chunk that alone takes
/// longer than all others (libomp does the same; guided self-scheduling, Polychronopoulos & Kuck 1987, takes
/// the whole share, as libgomp does).
class ThreadGuided final : public Scheduler {
 public:
  explicit ThreadGuided(const SchedulerOptions& options) : pool_(options) {}

 private:
  void run_items(const ItemSpace& items, const Chunk& chunk, const Work& work) override {
    const size_t least = chunk.size(items, pool_.threads());
    const size_t shares = 2 * static_cast<size_t>(pool_.threads());
    SharedCounter next;
    pool_.run([&](int worker) {
      // Relaxed: only the numbers must differ; the pool orders everything before and after the run.
      size_t begin = next.value.load(std::memory_order_relaxed);
      while (begin < items.count) {
        const size_t left = items.count - begin;
        const size_t end = begin + std::min(left, std::max(least, (left + shares - 1) / shares));
        if (!next.value.compare_exchange_weak(begin, end, std::memory_order_relaxed)) continue;
        work(begin, end, worker);
        begin = next.value.load(std::memory_order_relaxed);
      }
    });
  }

  ThreadPool pool_;
};

}  // namespace

std::unique_ptr<Scheduler> make_thread_guided(const SchedulerOptions& options) {
  return std::make_unique<ThreadGuided>(options);
}

}  // namespace raysweep
