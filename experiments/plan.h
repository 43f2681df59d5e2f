// From a config to every launch, in order.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "experiments/cell.h"
#include "experiments/config.h"

namespace raysweep {

struct PlannedCell {
  Cell cell;
  std::string key;
  bool asked;  // by the sweep; else a base that the tables need
};

/// The cells of a run: the sweep's, and those that its tables compare them with: `serial`, one thread of the
/// same scheduler, and co-running serial processes, each for the same picture and item shape.
struct Plan {
  std::string experiment, title;
  double interval = 0;  // relative half-width to reach
  std::vector<PlannedCell> cells;
  int rounds = 0;
  uint64_t seed = 0;

  /// Indices of all cells in the random order of `round`. A function of seed and round alone, the same
  /// everywhere.
  [[nodiscard]] std::vector<size_t> order(int round) const;
};

/// Throws SceneError if the scene cannot have the lights that are asked for.
[[nodiscard]] Plan make_plan(const Config& config, const MachineSize& machine);

/// plan.json: every cell, in order, as a record without measurements; the seed and each round's order.
[[nodiscard]] nlohmann::json to_json(const Plan& plan);

}  // namespace raysweep
