// In how many rays two tracers differ.
#pragma once

#include <cstddef>

#include "tracer/ray_batch.h"

namespace raysweep {

struct HitDifferences {
  size_t rays = 0;        // that hit another triangle, or only one of the two hits at all
  size_t same_place = 0;  // of those: both hit, at distances that rounding alone tells apart
};

/// Distances closer than this, relative to them, are the same place: a ray through an edge that two triangles
/// share may be given to either. A computed distance is off by some ulps, more where the ray is flat; 2⁻¹⁸ is
/// 64 ulps of 1.
inline constexpr float same_place_share = 1.0f / (1 << 18);

/// Of nearest hits; of `any_hit`, only whether there is one counts. Both must be of the same `size` rays.
[[nodiscard]] HitDifferences differences(const HitBatch& a, const HitBatch& b, size_t size, bool any_hit);

}  // namespace raysweep
