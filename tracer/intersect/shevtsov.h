// Shevtsov, Soupikov & Kapustin 2007, "Ray–triangle intersection algorithm for modern CPU architectures".
#pragma once

#include "tracer/intersect/formula.h"

namespace raysweep {

/// The paper scales the edges by (−1)^w/N_w, which belongs to the axes of `project`: with cyclic ones β and γ
/// of every triangle with w = 1 would have the other sign. Here they are scaled by what that is, the inverse
/// of the projected edges' determinant.
struct Shevtsov {
  static constexpr std::string_view name = "shevtsov";
  static constexpr std::string_view summary =
      "Shevtsov, Soupikov & Kapustin 2007; projected plane and edges precomputed, divides late";
  static constexpr bool is_watertight = false;
  static constexpr bool gives_weights = true;
  static constexpr Division division = Division::late;
  static constexpr Order order = Order::distance_first;

  template <class T>
  struct Prepared {
    T nu, nv, d;           // the plane N_u/N_w·X_u + N_v/N_w·X_v + X_w = d
    T au, av;              // the corner A
    T abu, abv, acu, acv;  // the edges from A, scaled
    Axis<T> axis;

    template <class U>
    [[nodiscard]] Prepared<U> as() const {
      const auto round = [](const T& x) { return static_cast<U>(x); };
      return {round(nu),  round(nv),  round(d),   round(au),  round(av),
              round(abu), round(abv), round(acu), round(acv), axis};
    }
  };

  template <class T>
  [[nodiscard]] static Prepared<T> prepare(const Triangle<T>& t) {
    const Vec3<T> normal = cross(t.b - t.a, t.c - t.a);
    const Axis<T> axis = dominant_axis(normal);
    const Projected<T> n = project(normal, axis), a = project(t.a, axis);
    const Projected<T> ab = project(t.b - t.a, axis), ac = project(t.c - t.a, axis);
    const T nu = n.u / n.w, nv = n.v / n.w, scale = T(1) / (ab.u * ac.v - ab.v * ac.u);
    return {nu,           nv,  nu * a.u + nv * a.v + a.w, a.u, a.v, ab.u * scale, ab.v * scale, ac.u * scale,
            ac.v * scale, axis};
  }

  template <class V>
  class Terms {
   public:
    Terms(const Ray<V>& ray, const Prepared<V>& tri)
        : tri_(tri), o_(project(ray.origin, tri.axis)), d_(project(ray.direction, tri.axis)) {}

    [[nodiscard]] V det() const { return d_.u * tri_.nu + d_.v * tri_.nv + d_.w; }
    [[nodiscard]] V t() const { return tri_.d - (o_.u * tri_.nu + o_.v * tri_.nv + o_.w); }
    [[nodiscard]] V beta() const { return tri_.acv * u() - tri_.acu * v(); }
    [[nodiscard]] V gamma() const { return tri_.abu * v() - tri_.abv * u(); }

   private:
    /// From A to the point in the plane, times det.
    [[nodiscard]] V u() const { return t() * d_.u - det() * (tri_.au - o_.u); }
    [[nodiscard]] V v() const { return t() * d_.v - det() * (tri_.av - o_.v); }

    Prepared<V> tri_;
    Projected<V> o_, d_;
  };
};

}  // namespace raysweep
