// The cells of runs of each kind, ready for claims: their factors by the names of configs, and all that was
// measured of them.
#pragma once

#include <string>
#include <vector>

#include "results/accuracy_results.h"
#include "results/claims/observation.h"
#include "results/kernel_results.h"
#include "results/pixels_results.h"
#include "results/run_data.h"

namespace raysweep {

/// fps and frame_seconds; speedup (against serial) and speedup_one (against one thread of the same
/// scheduler), round by round; quality of the schedule, imbalance, chunks of a frame, empty_region_seconds,
/// build_seconds, and rays of a frame.
[[nodiscard]] std::vector<MeasuredCell> measured_cells(const RunData& run);

/// nanoseconds of a test or of an operation; of kernels that time every operation also ticks, by the factor
/// `statistic`.
[[nodiscard]] std::vector<MeasuredCell> measured_cells(const KernelData& run);

/// Errors and failures, which are exact: the same seed gives the same.
[[nodiscard]] std::vector<MeasuredCell> measured_cells(const AccuracyData& run);

/// Errors of pictures, which are exact, and nanoseconds of a ray.
[[nodiscard]] std::vector<MeasuredCell> measured_cells(const PixelsData& run);

/// The quantities of a kind, "picture", "kernel", "accuracy" or "pixels"; first the one that is meant where
/// none is named.
[[nodiscard]] std::vector<std::string> quantities_of(const std::string& kind);

/// The factors that cells of a kind have.
[[nodiscard]] std::vector<std::string> factors_of(const std::string& kind);

}  // namespace raysweep
