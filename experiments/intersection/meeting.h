// The formulas of a ray's line and a triangle's plane, over numbers of any kind.
#pragma once

#include <algorithm>

#include "experiments/intersection/integers.h"
#include "tracer/math/vec3.h"

namespace raysweep {

/// By Cramer's rule t = volume/determinant, and (1−β−γ, β, γ) = (of_a, of_b, of_c)/determinant. Corners are
/// taken relative to the origin first: `Value` has to hold differences, and products of three of them.
template <class Value>
struct Meeting {
  Vec3<Value> direction, a, b, c;
  Vec3<Value> normal;  // AB × AC
  Value determinant, volume, of_a, of_b, of_c;

  Meeting(const Vec3<Value>& ray_origin, const Vec3<Value>& ray_direction, const Vec3<Value>& corner_a,
          const Vec3<Value>& corner_b, const Vec3<Value>& corner_c)
      : direction(ray_direction),
        a(corner_a - ray_origin),
        b(corner_b - ray_origin),
        c(corner_c - ray_origin),
        normal(cross(corner_b - corner_a, corner_c - corner_a)),
        determinant(dot(direction, normal)),
        volume(dot(a, normal)),
        of_a(dot(direction, cross(b, c))),
        of_b(dot(direction, cross(c, a))),
        of_c(dot(direction, cross(a, b))) {}
};

template <class Value>
[[nodiscard]] bool is_zero(const Vec3<Value>& v) {
  return sign(v.x) == 0 && sign(v.y) == 0 && sign(v.z) == 0;
}

/// Whether a ray in the triangle's plane touches the triangle before it ends. `beyond(n, d)` is the sign of
/// n/d − t_max, where n/d is a t. All is decided in the projection along an axis that the plane does not
/// contain: it maps the plane one to one and keeps t.
template <class Value, class Beyond>
class InPlane {
 public:
  InPlane(const Meeting<Value>& meeting, const Beyond& beyond)
      : meeting_(meeting),
        beyond_(beyond),
        axis_(sign(meeting.normal.x) != 0   ? 0
              : sign(meeting.normal.y) != 0 ? 1
                                            : 2) {}

  [[nodiscard]] bool touches() const {
    const auto& [a, b, c] = corners();
    return starts_inside() || crosses(a, b) || crosses(b, c) || crosses(c, a);
  }

 private:
  struct Corners {
    const Vec3<Value>&a, &b, &c;
  };
  [[nodiscard]] Corners corners() const { return {meeting_.a, meeting_.b, meeting_.c}; }

  [[nodiscard]] Value area(const Vec3<Value>& p, const Vec3<Value>& q) const {
    const int x = (axis_ + 1) % 3, y = (axis_ + 2) % 3;
    return p[x] * q[y] - p[y] * q[x];
  }
  /// The origin is 0.
  [[nodiscard]] bool starts_inside() const {
    const auto& [a, b, c] = corners();
    const int u = sign(area(a, b)), v = sign(area(b, c)), w = sign(area(c, a));
    return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
  }
  [[nodiscard]] bool is_on_ray(const Value& numerator, const Value& denominator) const {
    return sign(numerator) * sign(denominator) >= 0 && beyond_(numerator, denominator) <= 0;
  }
  [[nodiscard]] bool crosses(const Vec3<Value>& p, const Vec3<Value>& q) const {
    const Vec3<Value>& d = meeting_.direction;
    const Value of_p = area(d, p), of_q = area(d, q);
    if (sign(of_p) * sign(of_q) > 0) return false;
    // An edge on the ray's line is left to its neighbours, which end at its corners.
    return sign(of_p) != sign(of_q) && is_on_ray(area(p, q), of_q - of_p);
  }

  const Meeting<Value>& meeting_;
  const Beyond& beyond_;
  int axis_;
};

}  // namespace raysweep
