#include "tracer/shade/radiance_bound.h"

#include <limits>

namespace raysweep {

namespace {

constexpr double highlight_rounding = 1.001;  // (1 + 4u)^1000 in float, and the rest of one surface's sum
constexpr double level_rounding = 1 + 1e-6;   // weights are products of a few roundings a level

double largest(const Colour& c) { return std::max({c.x, c.y, c.z}); }

double local_bound(const Scene& scene, const Material& m) {
  Colour light;
  for (const Light& l : scene.lights) light += l.intensity;
  const Colour sum =
      m.ambient * scene.ambient * m.k_ambient + light * (m.diffuse * m.k_diffuse + m.specular * m.k_specular);
  return highlight_rounding * std::pow(highlight_rounding, m.exponent / 1000) * largest(sum);
}

}  // namespace

RadianceBound::RadianceBound(const Scene& scene, int depth) : by_levels_(static_cast<size_t>(depth) + 1) {
  double local = 0, onwards = 0;
  for (const Material& m : scene.materials) {
    local = std::max(local, local_bound(scene, m));
    onwards = std::max(onwards, m.k_reflect + m.k_refract * std::max(1.0, largest(m.filter)));
    // Shadow rays pass any number of such surfaces.
    if (m.k_refract * largest(m.filter) > 1) local = std::numeric_limits<double>::infinity();
  }
  for (size_t n = 1; n < by_levels_.size(); ++n) {
    const double passed_on = onwards > 0 ? onwards * by_levels_[n - 1] : 0;
    by_levels_[n] = level_rounding * std::max(largest(scene.background), local + passed_on);
  }
}

}  // namespace raysweep
