// The facts of processors: which there are, how fast they may run.
#pragma once

#include "experiments/machine/machine_facts.h"

namespace raysweep {

/// How often the allowed processors were slowed down because they were too hot, summed; none if none tells.
[[nodiscard]] std::optional<double> thermal_throttles(const std::vector<int>& processors,
                                                      const std::filesystem::path& root);

/// Fills in the first group of facts and `invariant_tsc`.
void read_processors(const OwnProcessors& own, const std::filesystem::path& root, MachineFacts& facts);

}  // namespace raysweep
