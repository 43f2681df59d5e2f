// The hits of a scene's own rays, and the numbers of them that errors depend on.
#pragma once

#include <cstdint>
#include <vector>

#include "tracer/intersect/intersector.h"

namespace raysweep {

struct Scene;

/// A ray and the triangle that it meets first.
struct SampledHit {
  Ray<float> ray;
  Triangle<float> triangle;
};

/// A picture's size and the seed of diffuse rays: others give other rays of the same scene.
struct SampleSize {
  int width, height;
  uint64_t seed;
};
/// What predictions are made from; what is measured has to be on other rays.
inline constexpr SampleSize predicted_sample{96, 72, 1}, measured_sample{192, 144, 2};
/// What is measured on where that does not tell whether a tolerance is kept.
inline constexpr SampleSize decisive_sample{768, 576, 3};

/// The first hits on triangles of rays as rendering sends them: primary ones through a picture's pixels, and
/// from where each of them hits one towards the first light, one reflected and one diffuse. Refracted rays go
/// ways that diffuse ones go, too. Rays and triangles are those of the precision float; in double the same
/// numbers are computed with more digits. One sample for each of `sizes`, the same on every machine. Builds a
/// hierarchy for it.
[[nodiscard]] std::vector<std::vector<SampledHit>> sample_hits(const Scene& scene,
                                                               const std::vector<SampleSize>& sizes);

/// The diagonal of the box around all triangles, in scene units; 0 without triangles.
[[nodiscard]] double scene_size(const Scene& scene);

/// Middle and bad end of a number over the hits: half of them and 99.9 % are better.
struct Spread {
  double median = 0, bad_end = 0;
};

/// Lengths in scene units; all 0 without hits.
struct HitNumbers {
  Spread coordinate;  // largest of the ray's origin and the corners
  Spread distance;    // from the ray's origin to the hit
  Spread edge;        // the longest; the shorter the worse
  Spread thinness;    // altitude on the longest edge / that edge
  Spread cosine;      // |cos| between ray and normal
};
[[nodiscard]] HitNumbers numbers_of(const std::vector<SampledHit>& hits);

}  // namespace raysweep
