// The TBB family: parallel_for over a blocked_range, one scheduler a partitioner.
#include "schedulers/module.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

namespace raysweep {

namespace {

template <class Partitioner>
class TbbParallelFor final : public Scheduler {
 public:
  explicit TbbParallelFor(int threads)
      : limit_(tbb::global_control::max_allowed_parallelism, static_cast<size_t>(threads)), arena_(threads) {}

 private:
  void run_items(const ItemSpace& items, const Chunk& chunk, const Body& body) override {
    const size_t grain = chunk.size(items.count, arena_.max_concurrency());
    arena_.execute([&] {
      tbb::parallel_for(
          tbb::blocked_range<size_t>(0, items.count, grain),
          [&](const tbb::blocked_range<size_t>& r) {
            body(r.begin(), r.end(), tbb::this_task_arena::current_thread_index());
          },
          partitioner_);
    });
  }

  // Both are needed: the control alone leaves the arena at the processors' count, the arena alone starts no
  // more workers than there are processors.
  tbb::global_control limit_;
  tbb::task_arena arena_;
  // One object for all runs: affinity_partitioner remembers in it which worker ran which items.
  Partitioner partitioner_;
};

template <class Partitioner>
std::unique_ptr<Scheduler> make(int threads) {
  return std::make_unique<TbbParallelFor<Partitioner>>(threads);
}

}  // namespace

extern "C" const Module* raysweep_module() {
  static const Module module{{{"tbb_auto", make<tbb::auto_partitioner>},
                              {"tbb_simple", make<tbb::simple_partitioner>},
                              {"tbb_static", make<tbb::static_partitioner>},
                              {"tbb_affinity", make<tbb::affinity_partitioner>}},
                             std::string("TBB ") + TBB_runtime_version() + ", " +
                                 library_of(reinterpret_cast<const void*>(&TBB_runtime_version))};
  return &module;
}

}  // namespace raysweep
