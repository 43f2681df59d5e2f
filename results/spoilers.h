// Why the launches of a cell may say more of the machine than of the cell.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/rounds.h"

namespace raysweep {

/// The largest values of a cell's valid launches; none where no launch knows them.
struct Disturbance {
  std::optional<double> other_processors, steal_share, pressure_share, throttled_seconds, spin_excess;
  /// "beside other load: up to 0.98 processors in 5 of 7 launches"; empty where nothing disturbed. Pressure
  /// is no reason: cells with more threads than processors make it themselves.
  std::vector<std::string> reasons;
};

/// From here on a launch counts as disturbed.
namespace spoiling {
/// A tenth of a processor: an idle desktop's own work is below, and 2 busy processors lose at most 5 %.
inline constexpr double other_processors = 0.1;
/// Of the time: the width asked of intervals is 2 %.
inline constexpr double steal_share = 0.02;
/// A fixed chain of instructions took so much longer than usual: the steps of turbo are smaller (100 MHz of 3
/// GHz).
inline constexpr double spin_excess = 0.05;
/// Of the launches: single ones that began cold, or whose short spin was interrupted, happen on any machine.
inline constexpr double often = 0.25;
}  // namespace spoiling

/// Seconds of the fixed chain of instructions that the run's launches show before and after: the median; none
/// where it was not measured.
[[nodiscard]] std::optional<double> usual_spin_seconds(const std::vector<Record>& records);

/// Of the valid launches of one cell.
[[nodiscard]] Disturbance disturbance_of(const Rounds& launches, std::optional<double> usual_spin_seconds);

}  // namespace raysweep
