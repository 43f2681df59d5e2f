// From a cell of a kernel other than intersection to its record.
#pragma once

#include "experiments/kernel_plan.h"
#include "results/kernel_record.h"

namespace raysweep {

/// Compares what is computed, then times it. Data are laid out anew each time, so that rounds differ by where
/// they lie. `iterations`: passes a sample, 0 if they are to be found out.
[[nodiscard]] KernelRecord measure_small_kernel(const KernelPlan& plan, const KernelCell& cell, int round,
                                                uint64_t iterations);

}  // namespace raysweep
