// How long a run would take, before it is begun.
#pragma once

#include <vector>

#include "experiments/runner.h"

namespace raysweep {

/// Seconds, budgets aside.
struct TimeEstimate {
  double first_rounds = 0;  // each cell as often as it is launched at least
  double all_rounds = 0;    // as often as it is launched at most
};

/// From a small cold picture of each that the plans hold, an eighth as wide and high. Cells that several
/// plans have are launched once for all. Threads are taken to share a frame evenly, so what does not scale
/// takes longer. Throws WorkError if a picture cannot be had.
[[nodiscard]] TimeEstimate estimate_time(const std::vector<Config>& configs, const std::vector<Plan>& plans,
                                         const MachineSize& machine, const RunnerTools& tools);

}  // namespace raysweep
