// Keidy's point-in-triangle test, from Fauerby 2003, "Improved collision detection and response".
#pragma once

#include "tracer/intersect/plane_terms.h"

namespace raysweep {

/// Fauerby tests the sign bits of z & ~(x|y), z = x + y − whole: β ≥ 0, γ ≥ 0 and β + γ < 1, where −0 counts
/// as negative. Here the edges are the variant's, as those of every other method.
struct Keidy {
  static constexpr std::string_view name = "keidy";
  static constexpr std::string_view summary =
      "Keidy's test, from Fauerby 2003; plane and the edges' products precomputed";
  static constexpr bool is_watertight = false;
  static constexpr bool gives_weights = true;
  static constexpr Division division = Division::early;
  static constexpr Order order = Order::distance_first;

  template <class T>
  struct Prepared {
    TrianglePlane<T> plane;
    Vec3<T> a, ab, ac;
    T ab_ab, ab_ac, ac_ac;

    template <class U>
    [[nodiscard]] Prepared<U> as() const {
      const auto round = [](const T& x) { return static_cast<U>(x); };
      return {plane.template as<U>(), Vec3<U>(a),   Vec3<U>(ab), Vec3<U>(ac),
              round(ab_ab),           round(ab_ac), round(ac_ac)};
    }
  };

  template <class T>
  [[nodiscard]] static Prepared<T> prepare(const Triangle<T>& t) {
    const Vec3<T> ab = t.b - t.a, ac = t.c - t.a;
    return {plane_of(t), t.a, ab, ac, dot(ab, ab), dot(ab, ac), dot(ac, ac)};
  }

  template <class V>
  class Terms : public PlaneTerms<V, Prepared<V>> {
   public:
    using PlaneTerms<V, Prepared<V>>::PlaneTerms;

    [[nodiscard]] V whole() const {
      const Prepared<V>& tri = this->tri();
      return tri.ab_ab * tri.ac_ac - tri.ab_ac * tri.ab_ac;
    }
    [[nodiscard]] auto at(const V& t, const V& w) const {
      const Prepared<V>& tri = this->tri();
      const Vec3<V> ap = this->point(t, w) - tri.a * w;
      return Point{tri, dot(ap, tri.ab), dot(ap, tri.ac)};
    }

   private:
    struct Point {
      Prepared<V> tri;
      V ap_ab, ap_ac;
      [[nodiscard]] V beta() const { return ap_ab * tri.ac_ac - ap_ac * tri.ab_ac; }
      [[nodiscard]] V gamma() const { return ap_ac * tri.ab_ab - ap_ab * tri.ab_ac; }
    };
  };
};

}  // namespace raysweep
