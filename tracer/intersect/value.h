// What a formula asks of the type that it computes with, beyond + − · / and comparisons.
#pragma once

#include <cmath>
#include <concepts>
#include <limits>

#if defined(__SSE__)
#include <xmmintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#endif

#include "tracer/math/vec3.h"

// A formula is written once, for one number or for many: for float, double, exact rationals and SIMD lanes.
// So it has no `if` on values, and what differs from type to type is found here by overloading: another type
// brings functions of these names with it, in its own namespace. A type that has no infinity may divide by
// zero all the same, if no comparison accepts what comes out.
namespace raysweep {

// Truth values: what comparisons give.
[[nodiscard]] constexpr bool both(bool a, bool b) { return a && b; }
[[nodiscard]] constexpr bool negation(bool mask) { return !mask; }
[[nodiscard]] constexpr bool none(bool mask) { return !mask; }
/// `yes` where `mask` holds, else `no`.
template <std::floating_point T>
[[nodiscard]] constexpr T select(bool mask, T yes, T no) {
  return mask ? yes : no;
}

/// The greatest finite number.
template <std::floating_point T>
[[nodiscard]] constexpr T greatest(T /*type*/) {
  return std::numeric_limits<T>::max();
}
/// Stands where a number was not asked for: no comparison accepts it.
template <std::floating_point T>
[[nodiscard]] constexpr T not_given(T /*type*/) {
  return std::numeric_limits<T>::quiet_NaN();
}

/// The angle of the point (x, y) from the x axis, in radians. Types without it cannot sum angles.
template <std::floating_point T>
[[nodiscard]] T arc_tangent(T y, T x) {
  return std::atan2(y, x);
}
template <std::floating_point T>
[[nodiscard]] T square_root(T x) {
  return std::sqrt(x);
}

// 1/x so near that one step of Newton's mends a float. An estimate of doubles has 8 to 14 bits where there is
// one, so that two or three steps would follow; and to go through float would cut the range of the exponent:
// double has no such overload.
#if defined(__SSE__)
/// With a relative error of at most 1.5·2⁻¹², by the instruction for it (Intel's manual: RCPSS).
template <std::same_as<float> T>  // a double would be converted
[[nodiscard]] T approximate_reciprocal(T x) {
  return _mm_cvtss_f32(_mm_rcp_ss(_mm_set_ss(x)));
}
#elif defined(__aarch64__)
/// With a relative error of about 2⁻¹⁶: the instruction for it has 8 bits (Arm's manual: FRECPE), to which a
/// first step, FRECPS, belongs.
template <std::same_as<float> T>
[[nodiscard]] T approximate_reciprocal(T x) {
  const float y = vrecpes_f32(x);
  return y * vrecpss_f32(x, y);
}
#endif

/// A vector in the coordinates of a projection: `w` along the axis that is dropped, `u` and `v` along the
/// others.
template <class V>
struct Projected {
  V u, v, w;
};

/// The axis dropped for one triangle. For lanes of triangles it is a lane each.
template <class V>
struct AxisOf {
  using Type = int;
};
template <class V>
using Axis = typename AxisOf<V>::Type;

/// u, v = y, z or x, z or x, y: the first two axes that are left.
template <class V>
[[nodiscard]] Projected<V> project(const Vec3<V>& a, int axis) {
  return {axis == 0 ? a.y : a.x, axis == 2 ? a.y : a.z, a[axis]};
}

/// The axis along which `a` is longest; of equal ones the last, as `longest_axis`, which is for floating
/// point only.
template <class V>
[[nodiscard]] Axis<V> dominant_axis(const Vec3<V>& a) {
  const auto absolute = [](const V& x) { return select(x < V(0), V(-x), x); };
  const V x = absolute(a.x), y = absolute(a.y), z = absolute(a.z);
  return x > y && x > z ? 0 : y > z ? 1 : 2;
}

}  // namespace raysweep
