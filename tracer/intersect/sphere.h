// Ray against sphere.
#pragma once

#include <algorithm>
#include <optional>

#include "tracer/math/ray.h"

namespace raysweep {

/// Where the whole line of a ray enters and leaves a sphere.
template <class T>
struct SphereHit {
  T enter, leave;  // enter ≤ leave; negative behind the origin
};

/// The discriminant is taken from the distance between centre and ray, and the second root from the product
/// of both, so that far and small spheres keep their digits (Haines, Günther & Akenine-Möller 2019,
/// "Precision improvements for ray/sphere intersection").
///
/// The signs follow that of the computed `c = |O−C|² − r²`: an origin inside (c < 0) is always between both
/// roots, one outside never is. What spawns rays relies on it.
template <class T>
[[nodiscard]] std::optional<SphereHit<T>> intersect_sphere(const Ray<T>& ray, const Vec3<T>& centre,
                                                           T radius) {
  const Vec3<T> f = ray.origin - centre;
  const T a = dot(ray.direction, ray.direction);
  const T b = -dot(f, ray.direction);
  const T c = dot(f, f) - radius * radius;
  const Vec3<T> from_centre = f + (b / a) * ray.direction;
  T discriminant = radius * radius - dot(from_centre, from_centre);
  if (c < 0) discriminant = std::max(discriminant, T(0));  // from inside every ray leaves
  if (!(discriminant >= 0)) return std::nullopt;
  const T q = b + std::copysign(std::sqrt(a * discriminant), b);
  const T t0 = q == 0 ? T(0) : c / q, t1 = q / a;
  return SphereHit<T>{std::min(t0, t1), std::max(t0, t1)};
}

}  // namespace raysweep
