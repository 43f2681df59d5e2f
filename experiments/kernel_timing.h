// What all kernels ask of the timer, and what they keep of its answer.
#pragma once

#include "experiments/kernel_plan.h"
#include "experiments/kernel_timer.h"
#include "results/kernel_record.h"

namespace raysweep {

/// `iterations`: passes a sample, 0 if they are to be found out.
[[nodiscard]] inline TimingRequest timing_request(const KernelPlan& plan, const KernelCell& cell,
                                                  uint64_t iterations) {
  return {cell.key, plan.measure.samples, plan.measure.min_seconds, iterations, plan.wall_clock, {}};
}

inline void set_timing(KernelRecord& record, const Timing& timing) {
  record.iterations = timing.iterations;
  record.seconds = timing.seconds;
  record.clock = timing.clock;
}

}  // namespace raysweep
