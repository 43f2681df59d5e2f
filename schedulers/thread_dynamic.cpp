#include "schedulers/builtin.h"
#include "schedulers/thread_pool.h"

namespace raysweep {

namespace {

/// Workers take the next chunk from a shared counter when they are free.
class ThreadDynamic final : public Scheduler {
 public:
  explicit ThreadDynamic(int threads) : pool_(threads) {}

 private:
  void run_items(const ItemSpace& items, const Chunk& chunk, const Body& body) override {
    const size_t size = chunk.size(items.count, pool_.threads());
    std::atomic<size_t> next{0};
    pool_.run([&](int worker) {
      // Relaxed: only the numbers must differ; the pool orders everything before and after the run.
      for (size_t begin; (begin = next.fetch_add(size, std::memory_order_relaxed)) < items.count;) {
        body(begin, std::min(begin + size, items.count), worker);
      }
    });
  }

  ThreadPool pool_;
};

}  // namespace

std::unique_ptr<Scheduler> make_thread_dynamic(int threads) {
  return std::make_unique<ThreadDynamic>(threads);
}

}  // namespace raysweep
