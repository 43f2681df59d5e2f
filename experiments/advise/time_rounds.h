// What pictures and tests of hits cost: all in turn, in rounds, so that what slows the machine slows all
// alike.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "experiments/advise/hit_sample.h"
#include "tracer/settings.h"

namespace raysweep {

struct RoundOptions {
  double seconds = 6;  // that rounds may take together
  int least = 7;       // rounds that there are even so; fewer than six have no interval
  int most = 200;
  uint64_t seed = 1;  // of the order of building, and of runs in each round
};

/// Nanoseconds of processor time of one thread a ray of any kind, for each of `settings` in each round: a
/// whole picture of `scene` as `render` makes it, shading included, its hierarchy built before. All renderers
/// are held at once.
[[nodiscard]] std::vector<std::vector<double>> time_pictures(const Scene& scene,
                                                             const std::vector<RenderSettings>& settings,
                                                             const RoundOptions& options);

/// The base kernel of a method of the study, alone.
struct TimedKernel {
  std::string_view method, precision;
  std::vector<double> nanoseconds;  // a test, of each round
};

/// Each ray of `hits` against its own triangle, which it hits: no test ends early. Empty without hits.
[[nodiscard]] std::vector<TimedKernel> time_kernels(const std::vector<SampledHit>& hits,
                                                    const RoundOptions& options);

}  // namespace raysweep
