// Long thin triangles among each other, whose boxes no plane between them parts.
#pragma once

#include <random>

#include "tracer/scene/scene.h"

namespace raysweep {

/// `count` of them along the axes and, of those that `slanted` adds, along anything; then some without area,
/// and one that is met where others are. Three spheres are among them.
inline Scene sticks(int count, int slanted, float scale = 1) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> uniform(-1, 1);
  const auto anywhere = [&] {
    const float x = uniform(random), y = uniform(random), z = uniform(random);
    return Vec3f(x, y, z);
  };
  Mesh mesh;
  const auto add = [&](const Vec3f& a, const Vec3f& b, const Vec3f& c) {
    const auto first = static_cast<uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {a * scale, b * scale, c * scale});
    mesh.triangles.push_back({first, first + 1, first + 2});
  };
  for (int i = 0; i < count + slanted; ++i) {
    const Vec3f centre = anywhere() * 2;
    const Vec3f axes[3]{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const Vec3f along = i < count ? axes[i % 3] : normalize(anywhere()), across = cross(along, anywhere());
    add(centre - along, centre + along, centre + normalize(across) * 0.02f);
    if (i % 50 == 0) add(centre - along, centre, centre + along);
    if (i % 50 == 1) add(centre - along, centre + along, centre + normalize(across) * 0.02f);
  }
  Scene scene;
  scene.name = "sticks";
  scene.materials = {{}};
  scene.meshes = {mesh};
  const double s{scale};
  scene.spheres = {{{0, 0, 0}, 0.5 * s, 0}, {{s, 0, 0}, 0.8 * s, 0}, {{s, 0, 0}, 0.8 * s, 0}};
  scene.lights = light_dome(3, {0, 0.5 * s, 0}, 4 * s);
  scene.camera = {.position = {0.3 * s, s, 6 * s}, .target = {0, 0, 0}, .half_angle = 0.4};
  return scene;
}

}  // namespace raysweep
