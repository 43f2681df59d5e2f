// A half-line, and what a slab test wants to know of it in advance.
#pragma once

#include <cmath>

#include "tracer/math/vec3.h"

namespace raysweep {

/// Points `origin + t·direction`, `t > 0`. Cameras and shading make directions of length 1, so that `t` is a
/// distance.
template <class T>
struct Ray {
  Vec3<T> origin, direction;

  [[nodiscard]] Vec3<T> at(T t) const { return origin + t * direction; }
};

/// Whether every number of `ray` is finite. Others, NaN above all, would pass through every box of a
/// hierarchy.
template <class T>
[[nodiscard]] bool is_finite(const Ray<T>& ray) {
  return all_finite(ray.origin) && all_finite(ray.direction);
}

/// A ray with the reciprocals and signs of its direction, computed once and used for every box.
template <class T>
struct SlabRay {
  Vec3<T> origin, reciprocal;
  // 1 where the direction points to lower coordinates. By signbit, not by `< 0`: −0 has the reciprocal −inf.
  int negative_x, negative_y, negative_z;

  explicit SlabRay(const Ray<T>& ray)
      : SlabRay(ray, {T(1) / ray.direction.x, T(1) / ray.direction.y, T(1) / ray.direction.z}) {}
  /// With reciprocals that are at hand.
  SlabRay(const Ray<T>& ray, const Vec3<T>& reciprocals)
      : origin(ray.origin),
        reciprocal(reciprocals),
        negative_x(std::signbit(ray.direction.x)),
        negative_y(std::signbit(ray.direction.y)),
        negative_z(std::signbit(ray.direction.z)) {}
};

}  // namespace raysweep
