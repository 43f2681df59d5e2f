#include "results/spoilers.h"

#include <fmt/format.h>

#include <algorithm>

namespace raysweep {

namespace {

using Value = std::optional<double>;

Value larger(Value a, Value b) { return !a ? b : !b ? a : std::max(*a, *b); }

/// How many of the launches are above a threshold, and the largest of all.
struct Count {
  Value largest;
  int above = 0;
};

template <class Of>
Count count_above(const Rounds& launches, double threshold, Of&& of) {
  Count count;
  for (const auto& [round, launch] : launches) {
    const Value value = of(*launch);
    count.largest = larger(count.largest, value);
    count.above += value && *value > threshold;
  }
  return count;
}

/// The median does not mind fewer.
bool is_often(const Count& count, const Rounds& launches) {
  return static_cast<double>(count.above) >= spoiling::often * static_cast<double>(launches.size()) &&
         count.above > 0;
}

Value spin_excess(const LaunchState& state, Value usual) {
  const Value slower = larger(state.spin_before_seconds, state.spin_after_seconds);
  return slower && usual && *usual > 0 ? Value(*slower / *usual - 1) : std::nullopt;
}

}  // namespace

std::optional<double> usual_spin_seconds(const std::vector<Record>& records) {
  std::vector<double> spins;
  for (const Record& r : records) {
    for (const Value& spin : {r.state.spin_before_seconds, r.state.spin_after_seconds}) {
      if (spin) spins.push_back(*spin);
    }
  }
  return spins.empty() ? std::nullopt : Value(median(std::move(spins)));
}

Disturbance disturbance_of(const Rounds& launches, std::optional<double> usual_spin_seconds) {
  Disturbance found;
  const auto told = [&](const Count& count, const std::string& what) {
    if (count.above > 0)
      found.reasons.push_back(fmt::format("{} {} of {} launches", what, count.above, launches.size()));
    return count.largest;
  };
  const auto in_state = [&](std::optional<double> LaunchState::*field, double threshold) {
    return count_above(launches, threshold, [field](const Record& r) { return r.state.*field; });
  };
  const Count cold = count_above(launches, 0.5, [](const Record& r) { return Value(r.warm ? 0 : 1); });
  if (is_often(cold, launches)) {
    found.reasons.push_back(
        fmt::format("not warm when timing began ({} of {} launches)", cold.above, launches.size()));
  }
  const Count others = in_state(&LaunchState::other_processors, spoiling::other_processors);
  found.other_processors =
      told(others, fmt::format("beside other load: up to {:.2f} processors in", others.largest.value_or(0)));
  const Count steal = in_state(&LaunchState::steal_share, spoiling::steal_share);
  found.steal_share = told(steal, fmt::format("steal up to {:.0f} % in", steal.largest.value_or(0) * 100));
  found.throttled_seconds = told(in_state(&LaunchState::throttled_seconds, 0), "throttled by a quota in");
  (void)told(in_state(&LaunchState::thermal_throttles, 0), "throttled because it was hot in");
  const Count spin = count_above(launches, spoiling::spin_excess,
                                 [&](const Record& r) { return spin_excess(r.state, usual_spin_seconds); });
  found.spin_excess = spin.largest;
  if (is_often(spin, launches))
    (void)told(spin,
               fmt::format("the processor ran up to {:.0f} % slower in", spin.largest.value_or(0) * 100));
  found.pressure_share = in_state(&LaunchState::pressure_share, 1).largest;
  return found;
}

}  // namespace raysweep
