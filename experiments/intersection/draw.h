// Random numbers, directions and triangles that are the same on every machine: of the draws, sums, products,
// quotients and square roots alone, which IEEE 754 fixes.
#pragma once

#include "results/statistics/random.h"
#include "tracer/intersect/intersector.h"

namespace raysweep {

/// From 0 to below 1, in steps of 2⁻⁵³.
[[nodiscard]] double uniform(Random& random);
/// Of length at most 1.
[[nodiscard]] Vec3d point_in_ball(Random& random);
/// Of length 1 but for rounding, every one as likely.
[[nodiscard]] Vec3d any_direction(Random& random);
/// Of length 1, across `axis`, which is of length 1, too.
[[nodiscard]] Vec3d any_tangent(const Vec3d& axis, Random& random);
/// In the unit ball, of an area of at least 0.2.
[[nodiscard]] Triangle<double> plain_triangle(Random& random);
/// Of length 1, the cosine to `normal` from `least` to 1 or the negative of that.
[[nodiscard]] Vec3d view_of(const Vec3d& normal, double least, Random& random);
/// A point of the plane of `triangle`: inside three times of four, else mostly outside, and near.
[[nodiscard]] Vec3d point_about(const Triangle<double>& triangle, Random& random);

/// Cosine and sine of `share` of a full turn, 0 to 1; exact at quarters. The standard library's differ from
/// one to the next in last bits.
struct Turn {
  double cosine, sine;
  explicit Turn(double share);
};

[[nodiscard]] inline Vec3d normal_of(const Triangle<double>& t) {
  return normalize(cross(t.b - t.a, t.c - t.a));
}
[[nodiscard]] inline Triangle<double> moved(const Triangle<double>& t, const Vec3d& by, double scale = 1) {
  return {(t.a + by) * scale, (t.b + by) * scale, (t.c + by) * scale};
}
template <class T>
[[nodiscard]] Triangle<T> rounded(const Triangle<double>& t) {
  return {Vec3<T>(t.a), Vec3<T>(t.b), Vec3<T>(t.c)};
}
/// From `origin` to `target` with a direction of length 1.
template <class T>
[[nodiscard]] Ray<T> aimed(const Vec3<T>& origin, const Vec3<T>& target) {
  return {origin, normalize(target - origin)};
}

}  // namespace raysweep
