// What happened on the machine while something was timed: counters read before and after, and what lies
// between them.
#pragma once

#include <filesystem>
#include <optional>

#include "results/record.h"
#include "schedulers/binding.h"

namespace raysweep {

/// Counters that only grow; none: unknown here.
struct StateCounters {
  double wall_seconds = 0;                  // the steady clock
  double own_seconds = 0;                   // processor time of this process, without its children
  int processors = 0;                       // that are allowed
  std::optional<double> busy_seconds;       // of the allowed processors, whoever used them
  std::optional<double> steal_seconds;      // of the allowed processors, that the hypervisor gave to others
  std::optional<double> pressure_seconds;   // in which some task of the machine waited for a processor
  std::optional<double> throttled_seconds;  // of this process's control groups
  std::optional<double> thermal_throttles;
  std::optional<double> voluntary_switches, involuntary_switches, major_faults;  // of this process
};

/// The counters now, in less than a millisecond. Both readings must be given the same processors: where the
/// calling thread may have been bound in between, name them.
[[nodiscard]] StateCounters read_state(const std::filesystem::path& root = "/",
                                       const ProcessorSet& allowed = allowed_processors());

/// Shorter windows have no `other_processors` and no `steal_share`: /proc/stat counts ticks of 10 ms, which
/// is 10 % of this.
inline constexpr double least_window_seconds = 0.1;

/// What lies between two readings. `other_processors` are of the allowed ones, used by other processes, this
/// one's children among them, and by interrupts; `pressure_share` counts this process's threads too. No
/// spins.
[[nodiscard]] LaunchState change_between(const StateCounters& before, const StateCounters& after);

/// A proxy of the frequency of the processor it is called on: the fastest of a few repeats of a fixed chain
/// of dependent integer operations, each about 0.2 ms. Twice the time: half the frequency, or another thread
/// on the same core.
[[nodiscard]] double spin_seconds();

}  // namespace raysweep
