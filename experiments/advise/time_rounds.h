// What pictures and tests of hits cost: all in turn, in rounds, so that what slows the machine slows all
// alike.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "experiments/advise/hit_sample.h"
#include "results/statistics/random.h"
#include "tracer/settings.h"

namespace raysweep {

struct RoundOptions {
  double seconds = 6;   // that rounds may take together
  double longest = 30;  // that they may take where what they tell is not enough
  int least = 7;        // rounds that there are even so; fewer than six have no interval
  int most = 200;
  uint64_t seed = 1;  // of the order of building, and of runs in each round
};

/// Of each contestant a time in each round.
using RoundTimes = std::vector<std::vector<double>>;

/// Whole pictures of a scene as `render` makes them, shading included, by one renderer for each of some
/// settings. All renderers are held at once, their hierarchies built.
class PictureRace {
 public:
  PictureRace(const Scene& scene, const std::vector<RenderSettings>& settings, const RoundOptions& options);

  /// Nanoseconds of processor time of one thread a ray of any kind. Rounds go on after their time until
  /// `is_enough`, but no longer than the longest.
  [[nodiscard]] RoundTimes run(const std::function<bool(const RoundTimes&)>& is_enough);

 private:
  RoundOptions options_;
  Random random_;
  std::vector<std::function<double()>> runs_;
};

/// The base kernel of a method of the study, alone.
struct TimedKernel {
  std::string_view method, precision;
  std::vector<double> nanoseconds;  // a test, of each round
};

/// Each ray of `hits` against its own triangle, which it hits: no test ends early. Empty without hits.
[[nodiscard]] std::vector<TimedKernel> time_kernels(const std::vector<SampledHit>& hits,
                                                    const RoundOptions& options);

}  // namespace raysweep
