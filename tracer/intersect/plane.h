// Ray against plane.
#pragma once

#include <optional>

#include "tracer/math/ray.h"

namespace raysweep {

/// The distance to the plane `normal·X + offset = 0`, if it is positive and finite: its sign is that of the
/// computed values `normal·O + offset` and `normal·direction`.
template <class T>
[[nodiscard]] std::optional<T> intersect_plane(const Ray<T>& ray, const Vec3<T>& normal, T offset) {
  const T t = -(dot(normal, ray.origin) + offset) / dot(normal, ray.direction);
  if (!(t > 0 && t < std::numeric_limits<T>::infinity())) return std::nullopt;
  return t;
}

}  // namespace raysweep
