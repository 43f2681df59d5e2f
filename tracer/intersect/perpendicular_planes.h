// Two planes perpendicular to the triangle, scaled so that they give the weights (Havel 2008, its own
// method).
#pragma once

#include "tracer/intersect/plane_terms.h"

namespace raysweep {

struct PerpendicularPlanes {
  static constexpr std::string_view name = "perpendicular_planes";
  static constexpr std::string_view summary =
      "Havel 2008; plane and two planes that give the weights precomputed";
  static constexpr bool is_watertight = false;
  static constexpr bool gives_weights = true;
  static constexpr Division division = Division::early;
  static constexpr Order order = Order::distance_first;

  template <class T>
  struct Prepared {
    TrianglePlane<T> plane, of_b, of_c;

    template <class U>
    [[nodiscard]] Prepared<U> as() const {
      return {plane.template as<U>(), of_b.template as<U>(), of_c.template as<U>()};
    }
  };

  template <class T>
  [[nodiscard]] static Prepared<T> prepare(const Triangle<T>& t) {
    const TrianglePlane<T> plane = plane_of(t);
    const T scale = T(1) / dot(plane.normal, plane.normal);
    const Vec3<T> nb = cross(t.c - t.a, plane.normal) * scale, nc = cross(plane.normal, t.b - t.a) * scale;
    return {plane, {nb, dot(nb, t.a)}, {nc, dot(nc, t.a)}};
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
      [[nodiscard]] V beta() const { return side_of(tri.of_b, p, w); }
      [[nodiscard]] V gamma() const { return side_of(tri.of_c, p, w); }
    };
  };
};

}  // namespace raysweep
