// What workers burn after a run, before they sleep.
#pragma once

#include <functional>

namespace raysweep {

struct IdleBurn {
  double cpu_seconds;  // from the run's end until the process went quiet, or until the cap
  bool went_quiet;
};

/// Watches for at most this long.
inline constexpr double idle_burn_cap_seconds = 1;

/// Sleeps again and again until `cpu_seconds`, the processor time of this process, no longer grows. `sleep`
/// sleeps for about a millisecond and returns the seconds that passed.
[[nodiscard]] IdleBurn watch_idle(const std::function<double()>& cpu_seconds,
                                  const std::function<double()>& sleep);

/// The same with this process's clock and real sleep.
[[nodiscard]] IdleBurn watch_idle();

}  // namespace raysweep
