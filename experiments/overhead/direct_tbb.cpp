// TBB by hand against the schedulers on TBB.
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <memory>

#include "experiments/overhead/direct.h"

namespace raysweep {

namespace {

/// As many threads as asked for need both, as in schedulers/tbb/arena.h. Each loop's scheduler has an arena
/// of its own beside this one: in each run the workers come over, which the run before the timed one does.
struct Arena {
  explicit Arena(int threads)
      : limit(tbb::global_control::max_allowed_parallelism, static_cast<size_t>(threads)), arena(threads) {}
  tbb::global_control limit;
  tbb::task_arena arena;
};

template <class Partitioner>
void run(Arena& arena, size_t items, const Body& body) {
  arena.arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<size_t>(0, items, 1),
        [&](const tbb::blocked_range<size_t>& range) {
          body(range.begin(), range.end(), tbb::this_task_arena::current_thread_index());
        },
        Partitioner());
  });
}

std::vector<DirectLoop> loops(int threads) {
  const auto arena = std::make_shared<Arena>(threads);
  return {{"parallel_for, simple_partitioner, grain 1", "tbb_simple",
           [arena](size_t items, const Body& body, std::uint64_t) {
             run<tbb::simple_partitioner>(*arena, items, body);
           }},
          {"parallel_for, auto_partitioner, grain 1", "tbb_auto",
           [arena](size_t items, const Body& body, std::uint64_t) {
             run<tbb::auto_partitioner>(*arena, items, body);
           }},
          {"parallel_for, static_partitioner, grain 1", "tbb_static",
           [arena](size_t items, const Body& body, std::uint64_t) {
             run<tbb::static_partitioner>(*arena, items, body);
           }}};
}

}  // namespace

}  // namespace raysweep

int main(int argc, char** argv) {
  return raysweep::compare_directly({"overhead_direct_tbb", "", raysweep::loops}, argc, argv);
}
