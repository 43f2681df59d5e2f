// Runs of equally many tasks, longer and longer ones: what METG is read from.
#pragma once

#include "experiments/overhead/busy_work.h"
#include "experiments/overhead/row_samples.h"
#include "schedulers/scheduler.h"

namespace raysweep {

/// One item a chunk, in the words of every scheduler: thread_chunks takes its chunk as a count per thread.
/// `items` is a multiple of `threads`.
[[nodiscard]] inline Chunk one_item_chunks(size_t items, int threads) {
  return {static_cast<int>(items / static_cast<size_t>(threads)), Chunk::Unit::per_thread};
}

struct SweepLimits {
  double seconds;         // for all sizes together; a size that would exceed them is not begun
  WorkSpeed speed;        // of busy work
  double useful_at_once;  // min(threads, processors): what efficiency 1 would be
};

/// Fills `tasks` and `sizes`, ascending: from tasks far shorter than what handing one out costs, doubling,
/// until efficiency has stayed at what METG asks for or the time is over.
void sweep_task_sizes(Scheduler& scheduler, int threads, const SweepLimits& limits, RowSamples& samples);

/// Useful time over all time, where a task takes `task_ns`.
[[nodiscard]] double efficiency(double tasks, double task_ns, double useful_at_once, double seconds);

}  // namespace raysweep
