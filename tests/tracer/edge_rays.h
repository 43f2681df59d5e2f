// Rays aimed at the edges and corners of meshes, and meshes that are worth it.
#pragma once

#include <numbers>
#include <random>

#include "tracer/math/ray.h"
#include "tracer/scene/scene.h"

namespace raysweep {

inline Scene scene_of(std::vector<Mesh> meshes) {
  Scene scene;
  scene.materials = {{}};
  scene.meshes = std::move(meshes);
  return scene;
}

/// A closed sphere of 2·around·(rings − 1) triangles, its radius at each vertex 2 + U(0, 1).
inline Mesh rough_sphere(int around, int rings, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  Mesh mesh;
  const auto vertex = [&](double polar, double azimuth) {
    mesh.vertices.emplace_back((2 + uniform(random)) * Vec3d(std::sin(polar) * std::cos(azimuth),
                                                             std::cos(polar),
                                                             std::sin(polar) * std::sin(azimuth)));
  };
  vertex(0, 0);
  for (int ring = 1; ring < rings; ++ring) {
    for (int i = 0; i < around; ++i)
      vertex(std::numbers::pi * ring / rings, 2 * std::numbers::pi * i / around);
  }
  vertex(std::numbers::pi, 0);
  const auto at = [&](int ring, int i) {
    if (ring == 0) return 0u;
    if (ring == rings) return static_cast<uint32_t>(mesh.vertices.size() - 1);
    return static_cast<uint32_t>(1 + (ring - 1) * around + i % around);
  };
  for (int ring = 0; ring < rings; ++ring) {
    for (int i = 0; i < around; ++i) {
      if (ring > 0) mesh.triangles.push_back({at(ring, i), at(ring, i + 1), at(ring + 1, i)});
      if (ring + 1 < rings) mesh.triangles.push_back({at(ring, i + 1), at(ring + 1, i + 1), at(ring + 1, i)});
    }
  }
  return mesh;
}

/// A sheet of 2·side² triangles over [−1, 1]², its vertices up to `rough` off z = 0.
inline Mesh sheet(int side, double rough, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  Mesh mesh;
  for (int y = 0; y <= side; ++y) {
    for (int x = 0; x <= side; ++x)
      mesh.vertices.emplace_back(Vec3d(2.0 * x / side - 1, 2.0 * y / side - 1, rough * uniform(random)));
  }
  const auto at = [&](int x, int y) { return static_cast<uint32_t>(y * (side + 1) + x); };
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      mesh.triangles.push_back({at(x, y), at(x + 1, y), at(x, y + 1)});
      mesh.triangles.push_back({at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  }
  return mesh;
}

/// A corner of the triangle, once in three times, else a point of an edge.
template <class Random>
Vec3d point_on_border(const Mesh& mesh, const std::array<uint32_t, 3>& triangle, Random& random) {
  const size_t corner = random() % 3;
  const Vec3d a(mesh.vertices[triangle[corner]]), b(mesh.vertices[triangle[(corner + 1) % 3]]);
  return random() % 3 == 0 ? a : a + (b - a) * std::uniform_real_distribution<double>(0, 1)(random);
}

/// From `origin` to `target`, both rounded first.
template <class T>
Ray<T> ray_towards(const Vec3d& origin, const Vec3d& target) {
  return {Vec3<T>(origin), normalize(Vec3<T>(target) - Vec3<T>(origin))};
}

}  // namespace raysweep
