// Baldwin & Weber 2016, "Fast ray–triangle intersections by coordinate transformation", JCGT 5(3).
#pragma once

#include "tracer/intersect/formula.h"

namespace raysweep {

/// The affine map that takes A, B, C to (0,0,0), (1,0,0), (0,1,0). Of the directions that it may take to z
/// it takes an axis of the world, so that a column is known and nine numbers are left. The ray is mapped
/// whole: where its z is 0, x and y are β and γ.
struct BaldwinWeber {
  static constexpr std::string_view name = "baldwin_weber";
  static constexpr std::string_view summary =
      "Baldwin & Weber 2016; map to the unit triangle precomputed, 40 bytes in float";
  static constexpr bool is_watertight = false;
  static constexpr bool gives_weights = true;
  static constexpr Division division = Division::early;
  static constexpr Order order = Order::distance_first;

  /// One row of the map: u·X_u + v·X_v + one, and X_w besides in the row of z.
  template <class T>
  struct Row {
    T u, v, one;

    template <class U>
    [[nodiscard]] Row<U> as() const {
      return {static_cast<U>(u), static_cast<U>(v), static_cast<U>(one)};
    }
  };

  template <class T>
  struct Prepared {
    Row<T> x, y, z;
    Axis<T> axis;

    template <class U>
    [[nodiscard]] Prepared<U> as() const {
      return {x.template as<U>(), y.template as<U>(), z.template as<U>(), axis};
    }
  };

  template <class T>
  [[nodiscard]] static Prepared<T> prepare(const Triangle<T>& t) {
    const Vec3<T> normal = cross(t.b - t.a, t.c - t.a);
    const Axis<T> axis = dominant_axis(normal);
    const Projected<T> n = project(normal, axis);
    const Projected<T> a = project(t.a, axis), b = project(t.b, axis), c = project(t.c, axis);
    const Projected<T> ab = project(t.b - t.a, axis), ac = project(t.c - t.a, axis);
    const T scale = T(1) / (ab.u * ac.v - ab.v * ac.u);
    return {{ac.v * scale, -ac.u * scale, (c.u * a.v - c.v * a.u) * scale},
            {-ab.v * scale, ab.u * scale, -(b.u * a.v - b.v * a.u) * scale},
            {n.u / n.w, n.v / n.w, -dot(normal, t.a) / n.w},
            axis};
  }

  template <class V>
  class Terms {
   public:
    Terms(const Ray<V>& ray, const Prepared<V>& tri)
        : tri_(tri), o_(project(ray.origin, tri.axis)), d_(project(ray.direction, tri.axis)) {}

    [[nodiscard]] V det() const { return tri_.z.u * d_.u + tri_.z.v * d_.v + d_.w; }
    [[nodiscard]] V t() const { return -(tri_.z.u * o_.u + tri_.z.v * o_.v + o_.w + tri_.z.one); }
    [[nodiscard]] auto at(const V& t, const V& w) const { return Point{*this, t, w}; }

   private:
    struct Point {
      Terms terms;
      V t, w;
      [[nodiscard]] V beta() const { return terms.along(terms.tri_.x, t, w); }
      [[nodiscard]] V gamma() const { return terms.along(terms.tri_.y, t, w); }
    };
    /// A coordinate of the mapped ray, w times its point at t/w.
    [[nodiscard]] V along(const Row<V>& row, const V& t, const V& w) const {
      const V origin = row.u * o_.u + row.v * o_.v + row.one, direction = row.u * d_.u + row.v * d_.v;
      return origin * w + direction * t;
    }

    Prepared<V> tri_;
    Projected<V> o_, d_;
  };
};

}  // namespace raysweep
