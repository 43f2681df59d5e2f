// Is this machine fit to measure on? Judged from its facts and from a while of watching it: a pure function.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "experiments/machine/build_facts.h"
#include "experiments/machine/cycle_timer.h"
#include "experiments/machine/machine_facts.h"
#include "experiments/machine/machine_watch.h"
#include "results/noise_floor.h"
#include "results/tables/table.h"

namespace raysweep {

/// Unknown is not a warning: nobody can say.
enum class FindingState { bad, unknown, good };

struct Finding {
  std::string name;
  FindingState state = FindingState::unknown;
  std::string value;   // what was found; empty if unknown
  std::string why;     // bad: what is lost by leaving it so; unknown: why nobody can say
  std::string advice;  // bad: what to do, with the command where there is one
};

/// All that is judged.
struct Examination {
  MachineFacts facts;
  BuildFacts build;
  TimerReport timer;
  MachineWatch watch;
  NoiseFloor noise;           // of comparisons of `noise_launches` launches, by an A/A test
  std::string noise_unknown;  // why it is
};

inline constexpr int noise_launches = 7;  // as many as runs have of each cell, at least

/// Every check, what is bad first, then what is unknown, then what is good.
[[nodiscard]] std::vector<Finding> judge(const Examination& examination);

/// "2 things to mend before you trust small differences: governor, other load."
[[nodiscard]] std::string verdict(const std::vector<Finding>& findings);

/// State, check, value and why.
[[nodiscard]] Table table_of(const std::vector<Finding>& findings);

[[nodiscard]] nlohmann::json to_json(const Finding& finding);

}  // namespace raysweep
