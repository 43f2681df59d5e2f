// How bright a ray can be at most: what allows to leave rays out and say what that costs.
#pragma once

#include <vector>

#include "tracer/scene/scene.h"

namespace raysweep {

/// Proof, for the largest channel. A ray that may make `n` levels of hits returns either the background or
/// what a surface sends: at most `L` by itself (all cosines at most 1, all shadows open, and filters never
/// brighten) and `s` = k_reflect + k_refract times what its two rays return, however Fresnel's equations or
/// total reflection share that out: B(0) = 0, B(n) = max(background, L + s·B(n − 1)). Rounding widens cosines
/// and each level.
class RadianceBound {
 public:
  RadianceBound(const Scene& scene, int depth);

  /// The most that a ray with `levels` levels left, itself included, returns in any channel.
  [[nodiscard]] double at(int levels) const { return by_levels_[static_cast<size_t>(levels)]; }

 private:
  std::vector<double> by_levels_;
};

}  // namespace raysweep
