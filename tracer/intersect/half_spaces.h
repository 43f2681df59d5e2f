// Three planes through the edges, perpendicular to the triangle: inside is on the inner side of each.
#pragma once

#include "tracer/intersect/plane_terms.h"

namespace raysweep {

/// A textbook method (Havel 2008, chapter 3). The normals N×AB, N×BC and
/// N×CA point to the third corner as they are made: its own side, |N|², need not be computed.
struct HalfSpaces {
  static constexpr std::string_view name = "half_spaces";
  static constexpr std::string_view summary = "Textbook; plane and three edge planes precomputed, signs only";
  static constexpr bool is_watertight = false;
  static constexpr bool gives_weights = false;
  static constexpr Division division = Division::early;
  static constexpr Order order = Order::distance_first;

  template <class T>
  struct Prepared {
    TrianglePlane<T> plane, ab, bc, ca;

    template <class U>
    [[nodiscard]] Prepared<U> as() const {
      return {plane.template as<U>(), ab.template as<U>(), bc.template as<U>(), ca.template as<U>()};
    }
  };

  template <class T>
  [[nodiscard]] static Prepared<T> prepare(const Triangle<T>& t) {
    const TrianglePlane<T> plane = plane_of(t);
    const auto through = [&](const Vec3<T>& p, const Vec3<T>& q) {
      const Vec3<T> n = cross(plane.normal, q - p);
      return TrianglePlane<T>{n, dot(n, p)};
    };
    return {plane, through(t.a, t.b), through(t.b, t.c), through(t.c, t.a)};
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
      [[nodiscard]] V alpha() const { return side_of(tri.bc, p, w); }
      [[nodiscard]] V beta() const { return side_of(tri.ca, p, w); }
      [[nodiscard]] V gamma() const { return side_of(tri.ab, p, w); }
    };
  };
};

}  // namespace raysweep
