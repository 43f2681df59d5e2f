// The corners seen from a point: inside the angles between them sum to a full turn.
#pragma once

#include <numbers>

#include "tracer/intersect/plane_terms.h"

namespace raysweep {

/// A textbook method (Bourke 1987, "Determining if a point lies on the interior of a polygon"), kept as the
/// bad example. A corner itself is missed: no direction leads there.
struct AngleSum {
  static constexpr std::string_view name = "angle_sum";
  static constexpr std::string_view summary = "Textbook; plane precomputed, angles sum to a full turn";
  static constexpr bool is_watertight = false;
  static constexpr bool gives_weights = false;
  static constexpr Division division = Division::early;
  static constexpr Order order = Order::distance_first;

  /// Below a full turn by so much the sum still counts, in radians. Each angle has the error of two products
  /// of rounded differences, a few units in the last place of π; a point at height h outside an edge of
  /// length L loses about 8h/L, so that it is taken for inside up to 2·10⁻⁶ L in float.
  template <class T>
  static constexpr T tolerance = 128 * std::numeric_limits<T>::epsilon();

  template <class T>
  struct Prepared {
    Triangle<T> corners;
    TrianglePlane<T> plane;

    template <class U>
    [[nodiscard]] Prepared<U> as() const {
      return {corners.template as<U>(), plane.template as<U>()};
    }
  };

  template <class T>
  [[nodiscard]] static Prepared<T> prepare(const Triangle<T>& t) {
    return {t, plane_of(t)};
  }

  template <class V>
  class Terms : public PlaneTerms<V, Prepared<V>> {
   public:
    using PlaneTerms<V, Prepared<V>>::PlaneTerms;

    [[nodiscard]] auto encloses(const V& t) const requires requires(const V& v) {
      arc_tangent(v, square_root(v));
    }
    {
      const Vec3<V> p = this->point(t, V(1));
      const Triangle<V>& corners = this->tri().corners;
      const Vec3<V> a = corners.a - p, b = corners.b - p, c = corners.c - p;
      return angle(a, b) + angle(b, c) + angle(c, a) >= V(2 * std::numbers::pi) - tolerance<V>;
    }

   private:
    [[nodiscard]] static V angle(const Vec3<V>& a, const Vec3<V>& b) {
      const Vec3<V> n = cross(a, b);
      return arc_tangent(square_root(dot(n, n)), dot(a, b));
    }
  };
};

}  // namespace raysweep
