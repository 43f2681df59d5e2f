// Times passes of kernels.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace raysweep {

/// Does what is timed once, and tells a number that depends on all of it, so that no compiler leaves it out.
using TimedPass = std::function<double()>;

struct TimingRequest {
  std::string name;
  int samples = 1;
  double min_seconds = 0;   // a sample, where passes are not given
  uint64_t iterations = 0;  // passes a sample; 0: as many as `min_seconds` needs
  bool wall_clock = false;  // for one thread, too
  /// Done before each pass, and not timed: passes are then timed one by one, by the clock of ticks. None: all
  /// passes of a sample are timed together.
  std::function<void()> before{};
};

struct Timing {
  uint64_t iterations = 0;        // passes a sample
  std::vector<double> seconds{};  // a sample each
  std::string clock{};            // "processor" or "wall"
};

/// Why nothing can be timed in this build; empty if it can.
[[nodiscard]] std::string why_no_kernel_timer();

/// Times passes, each thread running one of `passes` as often as the others, after one that is not timed. Of
/// one thread processor time is told, which other programs change least, if nothing else is asked for; of
/// several wall time, until the last has ended. Not where `why_no_kernel_timer` says why.
[[nodiscard]] Timing time_passes(const std::vector<TimedPass>& passes, const TimingRequest& request);

}  // namespace raysweep
