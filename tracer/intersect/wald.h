// Wald 2004, "Realtime ray tracing and interactive global illumination", section 7.1.
#pragma once

#include "tracer/intersect/formula.h"

namespace raysweep {

/// Of Badouel's method as much as possible is computed ahead: nine numbers and the axis.
struct Wald {
  static constexpr std::string_view name = "wald";
  static constexpr std::string_view summary =
      "Wald 2004; projected plane and two projected lines precomputed, 40 bytes in float";
  static constexpr bool is_watertight = false;
  static constexpr bool gives_weights = true;
  static constexpr Division division = Division::early;
  static constexpr Order order = Order::distance_first;

  template <class T>
  struct Prepared {
    T nu, nv, d;  // the plane nu·X_u + nv·X_v + X_w = d
    T bu, bv, b;  // β = bu·X_u + bv·X_v + b
    T cu, cv, c;  // γ likewise
    Axis<T> axis;

    template <class U>
    [[nodiscard]] Prepared<U> as() const {
      const auto round = [](const T& x) { return static_cast<U>(x); };
      return {round(nu), round(nv), round(d),  round(bu), round(bv),
              round(b),  round(cu), round(cv), round(c),  axis};
    }
  };

  template <class T>
  [[nodiscard]] static Prepared<T> prepare(const Triangle<T>& t) {
    const Vec3<T> normal = cross(t.b - t.a, t.c - t.a);
    const Axis<T> axis = dominant_axis(normal);
    const Projected<T> n = project(normal, axis), a = project(t.a, axis);
    const Projected<T> ab = project(t.b - t.a, axis), ac = project(t.c - t.a, axis);
    const T nu = n.u / n.w, nv = n.v / n.w, scale = T(1) / (ab.u * ac.v - ab.v * ac.u);
    const T bu = ac.v * scale, bv = -ac.u * scale, cu = -ab.v * scale, cv = ab.u * scale;
    return {nu, nv, nu * a.u + nv * a.v + a.w, bu,  bv, -(bu * a.u + bv * a.v),
            cu, cv, -(cu * a.u + cv * a.v),    axis};
  }

  template <class V>
  class Terms {
   public:
    Terms(const Ray<V>& ray, const Prepared<V>& tri)
        : tri_(tri), o_(project(ray.origin, tri.axis)), d_(project(ray.direction, tri.axis)) {}

    [[nodiscard]] V det() const { return tri_.nu * d_.u + tri_.nv * d_.v + d_.w; }
    [[nodiscard]] V t() const { return tri_.d - o_.w - tri_.nu * o_.u - tri_.nv * o_.v; }
    [[nodiscard]] auto at(const V& t, const V& w) const {
      return Point{tri_, o_.u * w + d_.u * t, o_.v * w + d_.v * t, w};
    }

   private:
    struct Point {
      Prepared<V> tri;
      V u, v, w;
      [[nodiscard]] V beta() const { return u * tri.bu + v * tri.bv + tri.b * w; }
      [[nodiscard]] V gamma() const { return u * tri.cu + v * tri.cv + tri.c * w; }
    };

    Prepared<V> tri_;
    Projected<V> o_, d_;
  };
};

}  // namespace raysweep
