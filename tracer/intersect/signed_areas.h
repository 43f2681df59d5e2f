// Three areas that a point spans with the edges, along the normal: inside all have one sign.
#pragma once

#include "tracer/intersect/plane_terms.h"

namespace raysweep {

/// A textbook method (Ericson 2005, "Real-time collision detection", 5.4.2).
struct SignedAreas {
  static constexpr std::string_view name = "signed_areas";
  static constexpr std::string_view summary = "Textbook; plane precomputed, signs of three areas";
  static constexpr bool is_watertight = false;
  static constexpr bool gives_weights = false;
  static constexpr Division division = Division::early;
  static constexpr Order order = Order::distance_first;

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

    [[nodiscard]] auto at(const V& t, const V& w) const { return Point{this->tri(), this->point(t, w), w}; }

   private:
    struct Point {
      Prepared<V> tri;
      Vec3<V> p;
      V w;
      [[nodiscard]] V alpha() const { return area(tri.corners.b, tri.corners.c); }
      [[nodiscard]] V beta() const { return area(tri.corners.c, tri.corners.a); }
      [[nodiscard]] V gamma() const { return area(tri.corners.a, tri.corners.b); }
      [[nodiscard]] V area(const Vec3<V>& from, const Vec3<V>& to) const {
        return dot(tri.plane.normal, cross(to - from, p - from * w));
      }
    };
  };
};

}  // namespace raysweep
