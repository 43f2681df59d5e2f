// The oracle once more, as slow as it is plain: fractions, and the point of the plane itself.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cmath>

#include "experiments/intersection/oracle.h"

namespace raysweep {

struct RationalHit {
  ExactVerdict verdict = ExactVerdict::miss;
  bool meets_plane = false;
  mpq_class t, beta, gamma;
};

/// Of finite numbers, the ray not parallel to the plane: the point where it meets the plane, in coordinates
/// of the triangle's edges, found in a projection along an axis. Parallel rays are misses here, even in the
/// plane.
template <class T>
RationalHit rational_hit(const Ray<T>& ray, const Triangle<T>& triangle, T t_max) {
  using Point = std::array<mpq_class, 3>;
  const auto point = [](const Vec3<T>& v) { return Point{mpq_class(v.x), mpq_class(v.y), mpq_class(v.z)}; };
  const Point o = point(ray.origin), d = point(ray.direction), a = point(triangle.a), b = point(triangle.b),
              c = point(triangle.c);
  Point normal;
  for (size_t x = 0; x < 3; ++x) {
    const size_t y = (x + 1) % 3, z = (x + 2) % 3;
    normal[x] = (b[y] - a[y]) * (c[z] - a[z]) - (b[z] - a[z]) * (c[y] - a[y]);
  }
  mpq_class towards = 0, distance = 0;
  for (size_t x = 0; x < 3; ++x) {
    towards += d[x] * normal[x];
    distance += (a[x] - o[x]) * normal[x];
  }
  RationalHit hit;
  if (towards == 0) return hit;
  hit.meets_plane = true;
  hit.t = distance / towards;
  const size_t dropped = normal[0] != 0 ? 0 : normal[1] != 0 ? 1 : 2;
  const size_t y = (dropped + 1) % 3, z = (dropped + 2) % 3;
  const mpq_class py = o[y] + hit.t * d[y] - a[y], pz = o[z] + hit.t * d[z] - a[z];
  hit.beta = (py * (c[z] - a[z]) - pz * (c[y] - a[y])) / normal[dropped];
  hit.gamma = ((b[y] - a[y]) * pz - (b[z] - a[z]) * py) / normal[dropped];
  const mpq_class alpha = 1 - hit.beta - hit.gamma;
  const bool ends = !std::isinf(t_max);
  if (hit.t < 0 || alpha < 0 || hit.beta < 0 || hit.gamma < 0 || (ends && hit.t > mpq_class(t_max)))
    return hit;
  const bool is_narrow =
      hit.t == 0 || alpha == 0 || hit.beta == 0 || hit.gamma == 0 || (ends && hit.t == mpq_class(t_max));
  hit.verdict = is_narrow ? ExactVerdict::boundary : ExactVerdict::hit;
  return hit;
}

/// |value − exact| ≤ 2⁻⁶⁰·|exact|. `value` is split into two doubles, which fractions can be made of.
inline bool is_right_to_60_bits(long double value, const mpq_class& exact) {
  const auto high = static_cast<double>(value);
  const mpq_class error = abs(mpq_class(high) + mpq_class(static_cast<double>(value - high)) - exact);
  return error * mpq_class(0x1p60) <= abs(exact);
}

}  // namespace raysweep
