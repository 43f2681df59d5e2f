// Many rays and their answers, each number in an array of its own: what SIMD kernels and other tracers are
// handed.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "tracer/film.h"
#include "tracer/math/ray.h"

namespace raysweep {

/// Arrays of a batch hold a multiple of this many numbers, so that no vector reads past their end.
inline constexpr size_t batch_lanes = 16;

[[nodiscard]] constexpr size_t padded_to_lanes(size_t count) {
  return (count + batch_lanes - 1) / batch_lanes * batch_lanes;
}

template <class T>
using LaneArray = std::vector<T, CacheLineAllocator<T>>;

/// `size` rays; what lies beyond in the arrays is never looked at.
struct RayBatch {
  LaneArray<float> origin_x, origin_y, origin_z, direction_x, direction_y, direction_z;
  LaneArray<float> t_max;  // hits farther than this do not count; infinity where all do
  size_t size = 0;

  explicit RayBatch(size_t count) : size(count) {
    for (auto* array : {&origin_x, &origin_y, &origin_z, &direction_x, &direction_y, &direction_z, &t_max})
      array->resize(padded_to_lanes(count));
  }

  void set(size_t i, const Ray<float>& ray, float limit = std::numeric_limits<float>::infinity()) {
    origin_x[i] = ray.origin.x;
    origin_y[i] = ray.origin.y;
    origin_z[i] = ray.origin.z;
    direction_x[i] = ray.direction.x;
    direction_y[i] = ray.direction.y;
    direction_z[i] = ray.direction.z;
    t_max[i] = limit;
  }

  [[nodiscard]] Ray<float> ray(size_t i) const {
    return {{origin_x[i], origin_y[i], origin_z[i]}, {direction_x[i], direction_y[i], direction_z[i]}};
  }
};

/// The nearest hit of each ray of a batch: distance and primitive; `no_hit_id` and the ray's own `t_max`
/// where there is none. For rays that only ask whether anything is in their way, any hit's.
struct HitBatch {
  LaneArray<float> t;
  LaneArray<uint32_t> id;

  explicit HitBatch(size_t count) : t(padded_to_lanes(count)), id(padded_to_lanes(count), no_hit_id) {}
};

}  // namespace raysweep
