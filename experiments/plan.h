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
  bool asked;                        // by the sweep; else a base that the tables need
  std::vector<std::string> bases{};  // keys of the cells that it is compared with, as often as it is launched
};

/// The cells of a run: the sweep's, and those that its tables compare them with: `serial`, one thread of the
/// same scheduler, and co-running serial processes, each for the same picture and item shape (none where the
/// config wants no bases). One cell has a twin, launched beside it in each round: how far they differ is the
/// noise floor of the run.
struct Plan {
  std::string experiment, title;
  double interval = 0;  // relative half-width to reach
  std::vector<PlannedCell> cells;
  int rounds = 0, max_rounds = 0;  // in which all cells take part; in which those not yet converged do
  uint64_t seed = 0;
  ClaimSheet sheet{};

  /// Indices of all cells in the random order of `round`.
  [[nodiscard]] std::vector<size_t> order(int round) const;
};

/// Where a cell stands in a round: those with smaller numbers come first. A function of seed, round and key
/// alone, the same everywhere: cells keep their order whichever others take part.
[[nodiscard]] uint64_t turn(uint64_t seed, int round, const std::string& key);

/// Throws SceneError if the scene cannot have the lights that are asked for.
[[nodiscard]] Plan make_plan(const Config& config, const MachineSize& machine);

/// plan.json: every cell, in order, as a record without measurements; the seed and each round's order.
[[nodiscard]] nlohmann::json to_json(const Plan& plan);

}  // namespace raysweep
