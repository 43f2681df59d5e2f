// Every ray against every triangle, rays side by side: what is compared with hierarchies on millions of rays.
#pragma once

#include <array>
#include <span>

#include "tests/tracer/hit_rays.h"

namespace raysweep {

/// As many rays as a vector register of any x86-64 or AArch64 holds.
inline constexpr size_t lane_count = 4;
using Lanes = float __attribute__((vector_size(lane_count * sizeof(float))));
using LaneMask = decltype(Lanes() < Lanes());

inline Vec3<Lanes> in_all_lanes(const Vec3f& v) {
  return {Lanes{v.x, v.x, v.x, v.x}, Lanes{v.y, v.y, v.y, v.y}, Lanes{v.z, v.z, v.z, v.z}};
}

/// A group of rays, missing ones at the end filled up by the last.
struct RayLanes {
  Vec3<Lanes> origin, direction;

  explicit RayLanes(std::span<const TestRay<float>> rays) {
    for (size_t lane = 0; lane < lane_count; ++lane) {
      const Ray<float>& ray = rays[std::min(lane, rays.size() - 1)].ray;
      origin.x[lane] = ray.origin.x, origin.y[lane] = ray.origin.y, origin.z[lane] = ray.origin.z;
      direction.x[lane] = ray.direction.x, direction.y[lane] = ray.direction.y,
      direction.z[lane] = ray.direction.z;
    }
  }

  /// Where MollerTrumbore finds the barycentric coordinates inside: its arithmetic, operation by operation.
  [[nodiscard]] LaneMask inside(const MollerTrumbore::Prepared<float>& triangle) const {
    const Vec3<Lanes> ab = in_all_lanes(triangle.ab), ac = in_all_lanes(triangle.ac);
    const Vec3<Lanes> p = cross(direction, ac), ao = origin - in_all_lanes(triangle.a);
    const Lanes inverse = 1 / dot(ab, p), beta = dot(ao, p) * inverse;
    const Lanes gamma = dot(direction, cross(ao, ab)) * inverse;
    return (beta >= 0) & (beta <= 1) & (gamma >= 0) & (beta + gamma <= 1);
  }
};

/// The nearest hits of a group of rays, each found by trying all primitives.
template <class Primitives>
std::array<Hit<float>, lane_count> nearest_of_all(const Primitives& primitives,
                                                  std::span<const TestRay<float>> rays) {
  std::array<Hit<float>, lane_count> nearest;
  nearest.fill(Hit<float>::none(std::numeric_limits<float>::infinity()));
  const auto start = Hit<float>::start();
  const auto keep = [](Hit<float>& best, const std::optional<float>& t, uint32_t id) {
    if (const Hit<float> hit{t.value_or(0), id}; t && hit.before(best)) best = hit;
  };
  for (size_t i = 0; i < rays.size(); ++i) {
    const Ray<float>& ray = rays[i].ray;
    for (uint32_t id = 0; id < primitives.first_sphere(); ++id)
      keep(nearest[i], primitives.intersect_plane(id, ray, start), id);
    for (uint32_t id = primitives.first_sphere(); id < primitives.first_triangle(); ++id)
      keep(nearest[i], primitives.intersect_sphere(id, ray, SlabRay<float>(ray), start), id);
  }
  const RayLanes lanes(rays);
  for (uint32_t id = primitives.first_triangle(); id < primitives.count(); ++id) {
    const auto& triangle = primitives.triangle(id);
    const LaneMask inside = lanes.inside(triangle);
    if ((inside[0] | inside[1] | inside[2] | inside[3]) == 0) continue;
    for (size_t i = 0; i < rays.size(); ++i) {
      const Ray<float>& ray = rays[i].ray;
      if (inside[i])
        keep(nearest[i], primitives.intersect_triangle(id, triangle, ray, SlabRay<float>(ray), start), id);
    }
  }
  return nearest;
}

/// Whether `core` answers a ray as its nearest hit tells, bit for bit.
template <class Core>
bool is_answer(const Core& core, const TestRay<float>& test, const Hit<float>& nearest) {
  if (test.t_max < std::numeric_limits<float>::infinity())
    return core.occluded(test.ray, test.t_max) == (nearest.t < test.t_max);
  const auto hit = core.closest(test.ray);
  return hit ? hit->id == nearest.id && hit->t == nearest.t : nearest.is_none();
}

}  // namespace raysweep
