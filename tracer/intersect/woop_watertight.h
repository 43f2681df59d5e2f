// Woop, Benthin & Wald 2013, "Watertight ray/triangle intersection", JCGT 2(1).
#pragma once

#include <limits>
#include <type_traits>

#include "tracer/intersect/formula.h"

namespace raysweep {

/// The triangle is moved and sheared until the ray is the z axis. Where a corner comes to lie depends on the
/// ray and that corner alone, and whether the axis passes left or right of an edge is decided without error:
/// no ray passes between triangles that share an edge, nor at a corner between those that meet there. Needed
/// for that: no fused operations.
struct WoopWatertight {
  static constexpr std::string_view name = "woop_watertight";
  static constexpr std::string_view summary =
      "Woop, Benthin & Wald 2013; sheared along the ray, no ray passes at edges and corners";
  static constexpr bool is_watertight = true;
  static constexpr bool gives_weights = true;
  static constexpr Division division = Division::early;
  static constexpr Order order = Order::weights_first;

  template <class T>
  using Prepared = Triangle<T>;

  /// Edge functions below this, 0 above all, are computed again in `Wider`: the sign of 0 is unknown, and
  /// sums of others would underflow.
  template <class T>
  static constexpr T least_certain = std::is_same_v<T, float> ? T(0x1p-100)
                                                              : std::numeric_limits<T>::denorm_min();

  template <class T>
  [[nodiscard]] static Prepared<T> prepare(const Triangle<T>& t) {
    return t;
  }

  template <class T>
  [[nodiscard]] static std::optional<TriangleHit<T>> intersect(const Ray<T>& ray, const Prepared<T>& tri) {
    const Shear<T> shear(ray.direction);
    const Vec3<T> a = shear(tri.a - ray.origin), b = shear(tri.b - ray.origin), c = shear(tri.c - ray.origin);
    const Edges<T> edges(a, b, c);
    if (!edges.is_inside()) return std::nullopt;
    if (edges.is_certain()) return hit(edges, a, b, c, shear.along);
    const Vec3<Wider<T>> wide_a(a), wide_b(b), wide_c(c);
    const Edges<Wider<T>> exact(wide_a, wide_b, wide_c);
    if (!exact.is_inside()) return std::nullopt;
    return hit(exact, wide_a, wide_b, wide_c, shear.along);
  }

  /// The formula for the study, without what makes `intersect` certain: edge functions are those of V, never
  /// of a wider type, and weights may round above 1. So it is the paper's method without its fallback.
  template <class V>
  class Terms {
   public:
    Terms(const Ray<V>& ray, const Prepared<V>& tri) {
      const Axis<V> axis = dominant_axis(ray.direction);
      const Projected<V> d = project(ray.direction, axis);
      along_ = V(1) / d.w;
      const auto sheared = [&](const Vec3<V>& corner) {
        const Projected<V> p = project(corner - ray.origin, axis);
        return Vec3<V>(p.u - d.u * along_ * p.w, p.v - d.v * along_ * p.w, p.w);
      };
      a_ = sheared(tri.a);
      b_ = sheared(tri.b);
      c_ = sheared(tri.c);
    }

    [[nodiscard]] V det() const { return alpha() + beta() + gamma(); }
    [[nodiscard]] V t() const { return (alpha() * a_.z + beta() * b_.z + gamma() * c_.z) * along_; }
    [[nodiscard]] V alpha() const { return c_.x * b_.y - c_.y * b_.x; }
    [[nodiscard]] V beta() const { return a_.x * c_.y - a_.y * c_.x; }
    [[nodiscard]] V gamma() const { return b_.x * a_.y - b_.y * a_.x; }

   private:
    V along_;
    Vec3<V> a_, b_, c_;
  };

 private:
  /// Holds the product of two T without error; in double an edge function of 0 stays what it is, and the edge
  /// belongs to both its triangles.
  template <class T>
  using Wider = std::conditional_t<std::is_same_v<T, float>, double, T>;

  /// Swaps the axis along which the direction is longest for z and shears the direction onto it. The paper
  /// keeps the winding: here both sides count, and the other winding only turns all signs at once.
  template <class T>
  struct Shear {
    int x, y, z;
    T along, by_x, by_y;

    explicit Shear(const Vec3<T>& d) {
      z = longest_axis(d);
      x = z == 0 ? 2 : 0;
      y = z == 1 ? 2 : 1;
      along = T(1) / d[z];
      by_x = d[x] * along;
      by_y = d[y] * along;
    }
    [[nodiscard]] Vec3<T> operator()(const Vec3<T>& p) const {
      return {p[x] - by_x * p[z], p[y] - by_y * p[z], p[z]};
    }
  };

  /// Twice the areas that the axis spans with the edges opposite to A, B and C. A rounded product is never on
  /// the wrong side of another one, so that signs are right, or the difference is 0.
  template <class T>
  struct Edges {
    T u, v, w;

    Edges(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c)
        : u(c.x * b.y - c.y * b.x), v(a.x * c.y - a.y * c.x), w(b.x * a.y - b.y * a.x) {}

    [[nodiscard]] bool is_inside() const {
      return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
    }
    [[nodiscard]] bool is_certain() const {
      return std::min(std::min(std::abs(u), std::abs(v)), std::abs(w)) >= least_certain<T>;
    }
  };

  /// Rounding may take a weight, or the sum of two, above 1.
  template <class T, class W>
  [[nodiscard]] static std::optional<TriangleHit<T>> hit(const Edges<W>& e, const Vec3<W>& a,
                                                         const Vec3<W>& b, const Vec3<W>& c, T along) {
    const W inverse = W(1) / (e.u + e.v + e.w);
    const W of_b = e.v * inverse, of_c = e.w * inverse;
    const T t = static_cast<T>((e.u * inverse * a.z + of_b * b.z + of_c * c.z) * W(along));
    if (!(t > 0 && t < std::numeric_limits<T>::infinity())) return std::nullopt;
    const T beta = std::min(static_cast<T>(of_b), T(1));
    return TriangleHit<T>{t, beta, std::min(static_cast<T>(of_c), 1 - beta)};
  }
};

}  // namespace raysweep
