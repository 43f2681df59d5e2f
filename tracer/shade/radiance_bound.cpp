#include "tracer/shade/radiance_bound.h"

namespace raysweep {

namespace {

/// Cosines of computed unit vectors exceed 1 by what rounding in float adds to two normals, their reflection
/// and two directions: 32 half ulps are more. A highlight raises that to its exponent.
constexpr double largest_cosine = 1 + 32 * 0x1p-24;
constexpr double level_rounding = 1 + 1e-6;  // sums and weights: a few roundings a level

double largest(const Colour& c) { return std::max({c.x, c.y, c.z}); }

double local_bound(const Scene& scene, const Material& m) {
  Colour light;
  for (const Light& l : scene.lights) light += l.intensity;
  const Colour sum = m.ambient * scene.ambient * m.k_ambient +
                     light * (m.diffuse * (m.k_diffuse * largest_cosine) +
                              m.specular * (m.k_specular * std::pow(largest_cosine, m.exponent)));
  return largest(sum);
}

}  // namespace

RadianceBound::RadianceBound(const Scene& scene, int depth) : by_levels_(static_cast<size_t>(depth) + 1) {
  double local = 0, onwards = 0;
  for (const Material& m : scene.materials) {
    local = std::max(local, local_bound(scene, m));
    onwards = std::max(onwards, m.k_reflect + m.k_refract);
  }
  for (size_t n = 1; n < by_levels_.size(); ++n)
    by_levels_[n] = level_rounding * std::max(largest(scene.background), local + onwards * by_levels_[n - 1]);
}

}  // namespace raysweep
