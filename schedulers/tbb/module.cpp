// The TBB family: parallel_for, one scheduler a partitioner, and other ways to the same task scheduler.
#include "schedulers/module.h"

#include <tbb/blocked_range.h>
#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_group.h>

#include <cmath>

#include "schedulers/tbb/arena.h"
#include "schedulers/tbb/stdpar.h"

namespace raysweep {

namespace {

template <class Partitioner>
class TbbParallelFor final : public TbbScheduler {
  using TbbScheduler::TbbScheduler;
  void run_inside(const ItemSpace& items, const Chunk& chunk, const Work& work) override {
    tbb::parallel_for(
        tbb::blocked_range<size_t>(0, items.count, chunk.size(items, threads())),
        [&](const tbb::blocked_range<size_t>& r) { work(r.begin(), r.end(), this_worker()); }, partitioner_);
  }

  // One object for all runs: affinity_partitioner remembers in it which worker ran which items.
  Partitioner partitioner_;
};

/// parallel_for over a blocked_range2d of the items' grid. A chunk of n items is cut with a grain of √n in
/// both directions, or of n in the only one that there is; the simple partitioner makes them between half
/// that and all of it.
class TbbRange2d final : public TbbScheduler {
  using TbbScheduler::TbbScheduler;
  void run_inside(const ItemSpace& items, const Chunk& chunk, const Work& work) override {
    const size_t columns = items.columns > 0 ? items.columns : 1, rows = items.count / columns;
    const size_t size = chunk.size(items, threads());
    const bool flat = columns == 1 || rows == 1;
    const auto grain = flat ? size : static_cast<size_t>(std::lround(std::sqrt(static_cast<double>(size))));
    tbb::parallel_for(
        tbb::blocked_range2d<size_t>(0, rows, grain, 0, columns, grain),
        [&](const tbb::blocked_range2d<size_t>& r) {
          work({r.rows().begin(), r.rows().end(), r.cols().begin(), r.cols().end()}, columns, this_worker());
        },
        tbb::simple_partitioner());
  }
};

/// One task for each chunk, all made by the caller.
class TbbTaskGroup final : public TbbScheduler {
  using TbbScheduler::TbbScheduler;
  void run_inside(const ItemSpace& items, const Chunk& chunk, const Work& work) override {
    const size_t size = chunk.size(items, threads());
    tbb::task_group group;
    for (size_t begin = 0; begin < items.count; begin += size) {
      const size_t end = std::min(begin + size, items.count);
      group.run([&work, begin, end] { work(begin, end, this_worker()); });
    }
    group.wait();
  }
};

}  // namespace

extern "C" const Module* raysweep_module() {
  static const Module module{shared_layout,
                             {{"tbb_auto", make_tbb<TbbParallelFor<tbb::auto_partitioner>>},
                              {"tbb_simple", make_tbb<TbbParallelFor<tbb::simple_partitioner>>},
                              {"tbb_static", make_tbb<TbbParallelFor<tbb::static_partitioner>>},
                              {"tbb_affinity", make_tbb<TbbParallelFor<tbb::affinity_partitioner>>},
                              {"tbb_range2d", make_tbb<TbbRange2d>},
                              {"tbb_task_group", make_tbb<TbbTaskGroup>},
                              stdpar_entry()},
                             std::string("TBB ") + TBB_runtime_version(),
                             library_of(reinterpret_cast<const void*>(&TBB_runtime_version))};
  return &module;
}

}  // namespace raysweep
