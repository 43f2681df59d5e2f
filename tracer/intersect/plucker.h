// Sides of a ray to the edges in Plücker coordinates (Erickson 1997, "Plücker coordinates", Ray Tracing
// News).
#pragma once

#include <array>

#include "tracer/intersect/plane_terms.h"

namespace raysweep {

/// A shared edge gives both its triangles the same side but for the sign: no ray passes at edges. At corners
/// rays do pass, since three edges' rounded sides need not agree there.
struct Plucker {
  static constexpr std::string_view name = "plucker";
  static constexpr std::string_view summary = "Erickson 1997; edges in Pluecker coordinates precomputed";
  static constexpr bool is_watertight = false;
  static constexpr bool gives_weights = true;
  static constexpr Division division = Division::early;
  static constexpr Order order = Order::weights_first;

  /// The line through P and Q: Q−P and P×Q.
  template <class T>
  struct Line {
    Vec3<T> direction, moment;

    template <class U>
    [[nodiscard]] Line<U> as() const {
      return {Vec3<U>(direction), Vec3<U>(moment)};
    }
  };

  template <class T>
  struct Prepared {
    TrianglePlane<T> plane;
    Line<T> ab, bc, ca;

    template <class U>
    [[nodiscard]] Prepared<U> as() const {
      return {plane.template as<U>(), ab.template as<U>(), bc.template as<U>(), ca.template as<U>()};
    }
  };

  template <class T>
  [[nodiscard]] static Prepared<T> prepare(const Triangle<T>& t) {
    const auto line = [](const Vec3<T>& p, const Vec3<T>& q) { return Line<T>{q - p, cross(p, q)}; };
    return {plane_of(t), line(t.a, t.b), line(t.b, t.c), line(t.c, t.a)};
  }

  template <class V>
  class Terms {
   public:
    Terms(const Ray<V>& ray, const Prepared<V>& tri)
        : tri_(tri),
          origin_(ray.origin),
          direction_(ray.direction),
          moment_(cross(ray.origin, ray.direction)) {}

    /// The sides' sum is D·N.
    [[nodiscard]] V det() const { return alpha() + beta() + gamma(); }
    [[nodiscard]] V t() const { return tri_.plane.offset - dot(tri_.plane.normal, origin_); }
    [[nodiscard]] V alpha() const { return side(tri_.bc); }
    [[nodiscard]] V beta() const { return side(tri_.ca); }
    [[nodiscard]] V gamma() const { return side(tri_.ab); }

   private:
    [[nodiscard]] V side(const Line<V>& edge) const {
      return dot(direction_, edge.moment) + dot(moment_, edge.direction);
    }

    Prepared<V> tri_;
    Vec3<V> origin_, direction_, moment_;
  };
};

}  // namespace raysweep
