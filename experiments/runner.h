// Runs a plan: interleaved rounds of launches, each verified and written down before the next one starts.
#pragma once

#include <functional>
#include <map>

#include "experiments/launcher.h"
#include "experiments/machine.h"
#include "experiments/plan.h"
#include "experiments/run_folder.h"

namespace raysweep {

/// Why a run ended.
enum class RunEnd { complete, out_of_budget, interrupted };

struct RunReport {
  RunEnd end = RunEnd::complete;
  int launches = 0, void_launches = 0;
  int whole_rounds = 0;
};

struct RunnerTools {
  Launcher& launcher;
  std::function<double()> now;  // seconds
  bool quiet = false;           // no progress
};

/// Renders every picture of the plan once by `serial`, then launches all cells, round by round, each round in
/// its own random order, until all rounds are done, the budget is used up, or the user interrupts. A launch
/// whose picture differs from the serial one, or that fails, is recorded as void. Throws WorkError if a
/// serial picture cannot be had.
[[nodiscard]] RunReport run_plan(const Config& config, const Plan& plan, const Machine& machine,
                                 RunFolder& folder, const RunnerTools& tools);

}  // namespace raysweep
