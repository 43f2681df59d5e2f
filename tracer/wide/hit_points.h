// What a batch of rays has hit, each number in an array of its own, and the loops over it that compilers turn
// into vectors: no call, no branch, nothing looked up by index.
#pragma once

#include "tracer/accel/surface.h"
#include "tracer/ray_batch.h"
#include "tracer/shade/phong.h"

// What the next loop writes in one iteration, no other reads or writes: compilers cannot see that of so many
// arrays.
#ifdef __clang__
#define RAYSWEEP_INDEPENDENT_ITERATIONS _Pragma("clang loop vectorize(assume_safety)")
#else
#define RAYSWEEP_INDEPENDENT_ITERATIONS _Pragma("GCC ivdep")
#endif

namespace raysweep {

struct VectorLanes {
  LaneArray<float> x, y, z;

  explicit VectorLanes(size_t count)
      : x(padded_to_lanes(count)), y(padded_to_lanes(count)), z(padded_to_lanes(count)) {}

  [[nodiscard]] Vec3f operator[](size_t i) const { return {x[i], y[i], z[i]}; }
  void set(size_t i, const Vec3f& v) {
    x[i] = v.x;
    y[i] = v.y;
    z[i] = v.z;
  }
};

/// Of each hit; the rays that made them are in a batch of their own.
struct HitPoints {
  VectorLanes normal, mirrored;
  LaneArray<float> clearance;
  std::vector<const Surfacing<float>*> material;

  explicit HitPoints(size_t count)
      : normal(count), mirrored(count), clearance(padded_to_lanes(count)), material(count) {}
};

/// How one light stands to each hit.
struct Lit {
  VectorLanes to_light;
  LaneArray<float> distance, cosine, highlight;

  explicit Lit(size_t count)
      : to_light(count),
        distance(padded_to_lanes(count)),
        cosine(padded_to_lanes(count)),
        highlight(padded_to_lanes(count)) {}
};

/// `rays` hold points of surfaces, with the directions in which those were reached: points become what
/// mirrored rays start at, whose directions go into `mirrored`.
inline void mirror(RayBatch& rays, HitPoints& points) {
  RAYSWEEP_INDEPENDENT_ITERATIONS
  for (size_t i = 0; i < rays.size; ++i) {
    const Vec3f normal = points.normal[i];
    const Ray<float> in = rays.ray(i);
    // As `spawn` does on the ray's own side.
    points.mirrored.set(i, lifted(normalize(reflect(in.direction, normal)), normal));
    const Vec3f origin = in.origin + normal * points.clearance[i];
    rays.origin_x[i] = origin.x;
    rays.origin_y[i] = origin.y;
    rays.origin_z[i] = origin.z;
  }
}

/// From where mirrored rays start, to a light at `position`.
inline void look_at_light(const RayBatch& rays, const HitPoints& points, const Vec3f position, Lit& lit) {
  RAYSWEEP_INDEPENDENT_ITERATIONS
  for (size_t i = 0; i < rays.size; ++i) {
    const Ray<float> ray = rays.ray(i);
    const Vec3f normal = points.normal[i], towards = position - ray.origin;
    const float distance = length(towards);
    const Vec3f to_light = towards * (1 / distance);
    lit.to_light.set(i, to_light);
    lit.distance[i] = distance;
    lit.cosine[i] = dot(normal, to_light);
    lit.highlight[i] = highlight(normal, to_light, ray.direction);
  }
}

}  // namespace raysweep

#undef RAYSWEEP_INDEPENDENT_ITERATIONS
