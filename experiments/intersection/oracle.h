// What is true of a ray and a triangle: decided on the given floating-point numbers without any error.
#pragma once

#include <limits>

#include "tracer/intersect/intersector.h"

namespace raysweep {

/// `boundary`: nothing but a zero keeps it from being a hit or makes it one. Methods may answer as they like.
/// The ray meets an edge or a corner, or its t is exactly 0 or `t_max`, or it lies in the triangle's plane
/// and touches the triangle. Otherwise rays parallel to the plane miss, and so does every ray where the
/// triangle has exactly no area, the ray has no direction, or a number is infinite or NaN.
enum class ExactVerdict { miss, hit, boundary };

/// A verdict with values of the ray's line and the triangle's plane, each right to 60 bits at least; NaN
/// where the line meets the plane nowhere or everywhere. They are there for misses, too.
struct ExactHit {
  static constexpr long double nan = std::numeric_limits<long double>::quiet_NaN();

  ExactVerdict verdict = ExactVerdict::miss;
  long double t = nan, beta = nan, gamma = nan;
  long double rise = nan;   // how far from the plane the ray gets while t grows by 1
  bool non_finite = false;  // some input is infinite or NaN: a miss by definition
};

/// For T float and double; `t_max` ends the ray and may be infinite. Some microseconds for numbers whose
/// exponents differ widely, else a fraction of one.
template <class T>
[[nodiscard]] ExactHit exact_hit(const Ray<T>& ray, const Triangle<T>& triangle,
                                 T t_max = std::numeric_limits<T>::infinity());

/// The verdict of `exact_hit` alone, which takes a fraction of a microsecond unless it is a narrow one.
template <class T>
[[nodiscard]] ExactVerdict exact_verdict(const Ray<T>& ray, const Triangle<T>& triangle,
                                         T t_max = std::numeric_limits<T>::infinity());

}  // namespace raysweep
