#include "tracer/scene/scene.h"

#include <numbers>

namespace raysweep {

size_t Scene::triangle_count() const {
  size_t count = 0;
  for (const Mesh& mesh : meshes) count += mesh.triangles.size();
  return count;
}

std::string problem_of(const Material& m) {
  constexpr double rounding = 1e-9;  // of sums that are meant to be 1
  if (m.k_reflect + m.k_refract > 1 + rounding) return "k_reflect + k_refract must not exceed 1";
  if (std::max({m.filter.x, m.filter.y, m.filter.z}) > 1) return "filter must not exceed 1 in any channel";
  const auto is_good = [](const Colour& c) { return all_finite(c) && std::min({c.x, c.y, c.z}) >= 0; };
  for (const double k : {m.k_ambient, m.k_diffuse, m.k_specular, m.k_reflect, m.k_refract, m.exponent}) {
    if (!(std::isfinite(k) && k >= 0)) return "coefficients and exponent must be numbers from 0 on";
  }
  if (!is_good(m.ambient) || !is_good(m.diffuse) || !is_good(m.specular) || !is_good(m.filter))
    return "colours must be numbers from 0 on";
  if (!(std::isfinite(m.ior) && m.ior > 0)) return "ior must be a number above 0";
  return {};
}

bool has_transparency(const Scene& scene) {
  const auto refracts = [&](const auto& shape) { return scene.materials[shape.material].k_refract > 0; };
  return std::ranges::any_of(scene.planes, refracts) || std::ranges::any_of(scene.spheres, refracts) ||
         std::ranges::any_of(scene.meshes, refracts);
}

Box<double> bounds_of(const Mesh& mesh) {
  Box<double> box;
  for (const Vec3f& vertex : mesh.vertices) box.include(Vec3d(vertex));
  return box;
}

std::vector<Light> light_dome(int count, const Vec3d& target, double radius) {
  constexpr double golden_angle = std::numbers::pi * (3 - 2.23606797749979);  // (3 − √5)·π
  constexpr double key_share = 0.7;
  std::vector<Light> lights;
  for (int i = 0; i < count; ++i) {
    const double azimuth =
        2.4 + i * golden_angle;  // radians from +x towards +z, the viewer's side; 2.4 is left of it
    const double elevation = i == 0 ? 0.9 : 0.45 + 0.8 * std::fmod(i * 0.6180339887498949, 1.0);
    const Vec3d direction(std::cos(elevation) * std::cos(azimuth), std::sin(elevation),
                          std::cos(elevation) * std::sin(azimuth));
    const double share = count == 1 ? 1 : i == 0 ? key_share : (1 - key_share) / (count - 1);
    lights.push_back({target + radius * direction, Colour(share, share, share)});
  }
  return lights;
}

}  // namespace raysweep
