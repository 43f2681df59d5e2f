// Axis-aligned boxes and the slab test (Kay & Kajiya 1986), made conservative after Ize 2013.
#pragma once

#include <limits>

#include "tracer/math/ray.h"

namespace raysweep {

template <class T>
struct Box {
  // bounds[0] is the lower corner, bounds[1] the upper one. An empty box has lower > upper.
  Vec3<T> bounds[2] = {Vec3<T>(inf, inf, inf), Vec3<T>(-inf, -inf, -inf)};

  static constexpr T inf = std::numeric_limits<T>::infinity();

  void include(const Vec3<T>& p) {
    bounds[0] = min(bounds[0], p);
    bounds[1] = max(bounds[1], p);
  }
  void include(const Box& b) {
    bounds[0] = min(bounds[0], b.bounds[0]);
    bounds[1] = max(bounds[1], b.bounds[1]);
  }
  [[nodiscard]] const Vec3<T>& lower() const { return bounds[0]; }
  [[nodiscard]] const Vec3<T>& upper() const { return bounds[1]; }
  [[nodiscard]] Vec3<T> centre() const { return (bounds[0] + bounds[1]) * T(0.5); }
  [[nodiscard]] Vec3<T> size() const { return bounds[1] - bounds[0]; }
  [[nodiscard]] int longest_axis() const {
    const Vec3<T> s = size();
    return s.x >= s.y && s.x >= s.z ? 0 : s.y >= s.z ? 1 : 2;
  }
  /// Half the surface area; 0 for an empty box.
  [[nodiscard]] T half_area() const {
    if (bounds[0].x > bounds[1].x) return 0;
    const Vec3<T> s = size();
    return s.x * s.y + s.y * s.z + s.z * s.x;
  }
};

/// The part of a ray inside a box: `enter ≤ t ≤ leave`; empty if `enter > leave`.
template <class T>
struct Interval {
  T enter, leave;
  [[nodiscard]] bool empty() const { return !(enter <= leave); }
};

/// What rounding may take from the far end of an interval, as a factor.
template <class T>
inline constexpr T slab_widening = [] {
  constexpr T u = std::numeric_limits<T>::epsilon() / 2;
  return 1 + 2 * (5 * u / (1 - 5 * u));
}();

/// The interval inside `box` of the ray from `t_min` on.
///
/// Rounding never loses a box that the exact ray meets: `leave` is widened by 1 + 2γ(5), γ(n) = nu/(1 − nu),
/// u half an ulp of 1. For that, γ(3) would do (Ize 2013, "Robust BVH ray traversal"); but a watertight
/// method has to be believed where it sees a corner beside the exact ray. It begins with the same `bound −
/// origin` and rounds twice on each of two axes, as does what is below: 8u between these axes. A ray inside
/// the plane of a face gives 0·inf = NaN on that axis; both comparisons below are false for NaN, so the axis
/// is left out, which keeps the box.
///
/// The result is monotone: a box inside another one never gets the wider interval. Every operation is
/// (subtraction, multiplication by a constant of fixed sign, min, max, and rounding itself). `accept` in
/// primitives.h builds on it.
template <class T>
[[nodiscard, gnu::always_inline]] inline Interval<T> slab(const Box<T>& box, const SlabRay<T>& ray,
                                                          T t_min = 0) {
  const T near_x = (box.bounds[ray.negative_x].x - ray.origin.x) * ray.reciprocal.x;
  const T near_y = (box.bounds[ray.negative_y].y - ray.origin.y) * ray.reciprocal.y;
  const T near_z = (box.bounds[ray.negative_z].z - ray.origin.z) * ray.reciprocal.z;
  const T far_x = (box.bounds[1 - ray.negative_x].x - ray.origin.x) * ray.reciprocal.x;
  const T far_y = (box.bounds[1 - ray.negative_y].y - ray.origin.y) * ray.reciprocal.y;
  const T far_z = (box.bounds[1 - ray.negative_z].z - ray.origin.z) * ray.reciprocal.z;
  T enter = t_min;
  enter = near_x > enter ? near_x : enter;
  enter = near_y > enter ? near_y : enter;
  enter = near_z > enter ? near_z : enter;
  T leave = Box<T>::inf;
  leave = far_x < leave ? far_x : leave;
  leave = far_y < leave ? far_y : leave;
  leave = far_z < leave ? far_z : leave;
  return {enter, leave * slab_widening<T>};
}

}  // namespace raysweep
