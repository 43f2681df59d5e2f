// Runs plans: interleaved rounds of launches, each verified and written down before the next one starts.
#pragma once

#include <functional>
#include <vector>

#include "experiments/experiment_run.h"
#include "experiments/launcher.h"
#include "experiments/machine/machine.h"

namespace raysweep {

struct RunnerTools {
  Launcher& launcher;
  std::function<double()> now;  // seconds
  bool quiet = false;           // no progress
};

struct RunOutcome {
  std::vector<RunReport> reports;  // one an experiment, in their order
  std::string failure;             // a serial picture that cannot be had, a record that cannot be written
};

/// Launches all cells of all experiments, round by round, each round in its own random order: first as often
/// as each is to be launched at least, then those whose interval is too wide, until all have converged or
/// were launched as often as allowed, the experiments' budgets are used up, or the user interrupts. A cell
/// that several experiments have is launched once a round for all of them. Each picture is rendered once by
/// `serial`; a launch whose picture or rays differ from that one, that fails or takes too long, is recorded
/// as void.
[[nodiscard]] RunOutcome run_experiments(const std::vector<Experiment>& experiments, const Machine& machine,
                                         const RunnerTools& tools);

/// Seconds after which a launch of `cell` that times frames for `seconds` counts as hung, where the config
/// does not say: far more than it can take on a busy machine, by what the launch of its serial picture took.
[[nodiscard]] double default_timeout(const Cell& cell, double seconds, double picture_seconds);

}  // namespace raysweep
