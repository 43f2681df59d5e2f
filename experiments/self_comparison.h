// What comparing a cell with itself shows, now: the A/A test.
#pragma once

#include <string>
#include <vector>

#include "experiments/launcher.h"

namespace raysweep {

struct SelfComparison {
  std::vector<double> log_ratios;  // of fps, second launch of each pair by the first
  std::string failure;             // why there are fewer pairs than asked for; empty if there are not
};

/// A small picture on as many threads as there are processors: what a difference between schedulers is
/// looked for on.
[[nodiscard]] Cell self_comparison_cell(int processors);

/// Launches `cell` twice, one right after the other, `pairs` times, each timed for `seconds`.
[[nodiscard]] SelfComparison compare_with_itself(const Cell& cell, int pairs, double seconds,
                                                 Launcher& launcher);

}  // namespace raysweep
