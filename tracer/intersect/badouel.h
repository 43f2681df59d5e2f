// Badouel 1990, "An efficient ray–polygon intersection", Graphics Gems.
#pragma once

#include "tracer/intersect/plane_terms.h"

namespace raysweep {

struct Badouel {
  static constexpr std::string_view name = "badouel";
  static constexpr std::string_view summary =
      "Badouel 1990; plane and projected edges precomputed, Cramer's rule in the projection";
  static constexpr bool is_watertight = false;
  static constexpr bool gives_weights = true;
  static constexpr Division division = Division::early;
  static constexpr Order order = Order::distance_first;

  template <class T>
  struct Prepared {
    TrianglePlane<T> plane;
    T au, av, abu, abv, acu, acv;  // A, AB and AC in the projection
    Axis<T> axis;                  // that is dropped

    template <class U>
    [[nodiscard]] Prepared<U> as() const {
      const auto round = [](const T& x) { return static_cast<U>(x); };
      return {
          plane.template as<U>(), round(au), round(av), round(abu), round(abv), round(acu), round(acv), axis};
    }
  };

  template <class T>
  [[nodiscard]] static Prepared<T> prepare(const Triangle<T>& t) {
    const TrianglePlane<T> plane = plane_of(t);
    const Axis<T> axis = dominant_axis(plane.normal);
    const Projected<T> a = project(t.a, axis), ab = project(t.b - t.a, axis), ac = project(t.c - t.a, axis);
    return {plane, a.u, a.v, ab.u, ab.v, ac.u, ac.v, axis};
  }

  template <class V>
  class Terms : public PlaneTerms<V, Prepared<V>> {
   public:
    using PlaneTerms<V, Prepared<V>>::PlaneTerms;

    [[nodiscard]] V whole() const {
      return this->tri().abu * this->tri().acv - this->tri().abv * this->tri().acu;
    }
    [[nodiscard]] auto at(const V& t, const V& w) const {
      const Prepared<V>& tri = this->tri();
      const Projected<V> p = project(this->point(t, w), tri.axis);
      return Point{tri, p.u - tri.au * w, p.v - tri.av * w};
    }

   private:
    struct Point {
      Prepared<V> tri;
      V apu, apv;
      [[nodiscard]] V beta() const { return apu * tri.acv - apv * tri.acu; }
      [[nodiscard]] V gamma() const { return tri.abu * apv - tri.abv * apu; }
    };
  };
};

}  // namespace raysweep
