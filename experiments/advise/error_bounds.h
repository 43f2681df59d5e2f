// How far rounding may take what a method says of a ray and a triangle: bounds, without knowing the truth.
#pragma once

#include <span>
#include <string_view>

#include "tracer/intersect/intersector.h"

namespace raysweep {

/// Bounds of errors of one hit; infinite where nothing can be promised. Those of β and γ are NaN where the
/// method gives no weights.
struct HitBound {
  long double t = 0, beta = 0, gamma = 0;
  /// Of the hit point, in the scene's units: the larger of the distances from the true point at which O + tD
  /// and (1−β−γ)A + βB + γC may lie. Of methods without weights the first alone.
  long double point = 0;
};

/// A method of the study in its base variant over numbers of type T, float or double.
template <class T>
struct ErrorLaw {
  std::string_view method;
  /// The bound is the formula's own: `Rounded<T>` computes it as T does and keeps book of each rounding. So
  /// it grows with what the formula makes grow: with the largest coordinate where planes are stored relative
  /// to the world's origin, with the distance where the ray's origin is, with 1/cos where the ray is flat,
  /// with edge/altitude where the triangle is thin; and it is infinite where a divisor may be 0 or a product
  /// leaves T's range. No constant in it is fitted or chosen.
  HitBound (*bound)(const Ray<T>& ray, const Triangle<T>& triangle);
};

/// In the order of the study's list.
template <class T>
[[nodiscard]] std::span<const ErrorLaw<T>> error_laws();

/// Throws std::out_of_range for a name that no method of the study has.
template <class T>
[[nodiscard]] const ErrorLaw<T>& error_law_of(std::string_view method);

/// How far the hit point that `hit` tells is from the true one, measured as `HitBound::point` bounds it.
/// `t`, `beta` and `gamma` are the true ones.
template <class T>
[[nodiscard]] long double point_error(const Ray<T>& ray, const Triangle<T>& triangle,
                                      const TriangleHit<T>& hit, long double t, long double beta,
                                      long double gamma);

}  // namespace raysweep
