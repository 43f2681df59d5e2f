#include "schedulers/builtin.h"
#include "schedulers/thread_pool.h"

namespace raysweep {

namespace {

/// Morozov 2011's chunks per thread: `threads · k` near-equal chunks in a queue. A chunk of "k" and of
/// "k/thread" mean the same here.
class ThreadChunks final : public Scheduler {
 public:
  explicit ThreadChunks(int threads) : pool_(threads) {}

 private:
  void run_items(const ItemSpace& items, const Chunk& chunk, const Body& body) override {
    const size_t parts =
        std::min(items.count, static_cast<size_t>(pool_.threads()) * static_cast<size_t>(chunk.value));
    std::atomic<size_t> next{0};
    pool_.run([&](int worker) {
      // Relaxed: only the numbers must differ; the pool orders everything before and after the run.
      for (size_t part; (part = next.fetch_add(1, std::memory_order_relaxed)) < parts;) {
        body(block_begin(items.count, part, parts), block_begin(items.count, part + 1, parts), worker);
      }
    });
  }

  ThreadPool pool_;
};

}  // namespace

std::unique_ptr<Scheduler> make_thread_chunks(int threads) { return std::make_unique<ThreadChunks>(threads); }

}  // namespace raysweep
