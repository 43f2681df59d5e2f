#include "schedulers/builtin.h"
#include "schedulers/thread_pool.h"
#include "schedulers/work.h"

namespace raysweep {

namespace {

/// Morozov 2011's chunks per thread: `threads · k` near-equal chunks in a queue. A chunk of "k" and of
/// "k/thread" mean the same here.
class ThreadChunks final : public Scheduler {
 public:
  explicit ThreadChunks(const SchedulerOptions& options) : pool_(options) {}

 private:
  [[nodiscard]] size_t parts(const ItemSpace& items, const Chunk& chunk) const {
    const size_t size = chunk.size(items, pool_.threads());
    const size_t wanted = chunk.unit == Chunk::Unit::bytes
                              ? (items.count + size - 1) / size
                              : static_cast<size_t>(pool_.threads()) * static_cast<size_t>(chunk.value);
    return std::min(items.count, wanted);
  }

  void run_items(const ItemSpace& items, const Chunk& chunk, const Work& work) override {
    const size_t parts = this->parts(items, chunk);
    SharedCounter next;
    pool_.run([&](int worker) {
      // Relaxed: only the numbers must differ; the pool orders everything before and after the run.
      for (size_t part; (part = next.value.fetch_add(1, std::memory_order_relaxed)) < parts;) {
        work(block_begin(items.count, part, parts), block_begin(items.count, part + 1, parts), worker);
      }
    });
  }

  ThreadPool pool_;
};

}  // namespace

std::unique_ptr<Scheduler> make_thread_chunks(const SchedulerOptions& options) {
  return std::make_unique<ThreadChunks>(options);
}

}  // namespace raysweep
