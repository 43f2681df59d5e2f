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

/// Launches all cells, round by round, each round in its own random order, until all rounds are done, the
/// budget is used up, or the user interrupts. Each picture is rendered once by `serial`; a launch whose
/// picture or rays differ from that one, or that fails, is recorded as void. Throws WorkError if a serial
/// picture cannot be had, or a record not written.
[[nodiscard]] RunReport run_plan(const Config& config, const Plan& plan, const Machine& machine,
                                 RunFolder& folder, const RunnerTools& tools);

}  // namespace raysweep
