#include "schedulers/builtin.h"
#include "schedulers/thread_pool.h"

namespace raysweep {

namespace {

/// One contiguous block for each worker.
class ThreadStatic final : public Scheduler {
 public:
  explicit ThreadStatic(int threads) : pool_(threads) {}

 private:
  void run_items(const ItemSpace& items, const Chunk&, const Body& body) override {
    const auto parts = static_cast<size_t>(pool_.threads());
    pool_.run([&](int worker) {
      const auto part = static_cast<size_t>(worker);
      const size_t begin = block_begin(items.count, part, parts),
                   end = block_begin(items.count, part + 1, parts);
      if (begin < end) body(begin, end, worker);
    });
  }

  ThreadPool pool_;
};

}  // namespace

std::unique_ptr<Scheduler> make_thread_static(int threads) { return std::make_unique<ThreadStatic>(threads); }

}  // namespace raysweep
