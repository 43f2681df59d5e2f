// Who takes part in a comparison of tracers.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tracer/for_each.h"
#include "tracer/ray_batch.h"

namespace raysweep {

/// One way to trace a batch of rays. Only `run` is timed.
class Contestant {
 public:
  virtual ~Contestant() = default;
  [[nodiscard]] virtual std::string name() const = 0;
  /// Takes `rays` over into its own layout; they must outlive the contestant. `any_hit`: only whether
  /// something is in a ray's way, up to its `t_max`, is asked.
  virtual void prepare(const RayBatch& rays, bool any_hit) = 0;
  /// Undoes what a run wrote where the rays are; before each run.
  virtual void reset() = 0;
  virtual void run() = 0;
  /// What the run just before has found; of `any_hit`, any id.
  [[nodiscard]] virtual HitBatch hits() const = 0;
};

/// A contestant and what it may be compared as.
struct Entrant {
  std::unique_ptr<Contestant> contestant;
  bool single = false;  // one ray at a time, and a hierarchy of usual quality
  bool robust = false;  // promises to miss nothing at edges
};

/// What one build took.
struct BuildCost {
  double seconds = 0;
  size_t bytes = 0;  // held afterwards
};

/// A way to build, from triangles to what rays are traced in. The tracers' builds of one class and as many
/// threads are compared, each tracer's quickest.
struct TimedBuild {
  std::string build_class;  // "medium" or "high"
  int threads = 1;
  std::function<BuildCost()> run;  // builds, and drops what it built
};

/// All the ways of one tracer, for one scene, which must outlive them.
struct Team {
  std::vector<Entrant> entrants;
  std::vector<TimedBuild> builds;
};

/// A way to share work among as many threads, which wait for it as long as that lives.
using ShareWork = ForEach (*)(int threads);

/// Each build is timed in as many rounds.
inline constexpr int build_rounds = 7;
inline constexpr std::array build_threads{1, 2};

}  // namespace raysweep
