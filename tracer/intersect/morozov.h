// Morozov 2011, formula (10): Cramer's rule with a stored normal, distance first.
#pragma once

#include <limits>

#include "tracer/intersect/formula.h"

namespace raysweep {

struct Morozov {
  static constexpr std::string_view name = "morozov";
  static constexpr std::string_view summary =
      "Morozov 2011, formula (10); normal and edges precomputed, distance first";
  static constexpr bool is_watertight = false;
  static constexpr bool gives_weights = true;
  static constexpr Division division = Division::early;
  static constexpr Order order = Order::distance_first;

  template <class T>
  struct Prepared {
    Vec3<T> v0, e1, e2, n;

    template <class U>
    [[nodiscard]] Prepared<U> as() const {
      return {Vec3<U>(v0), Vec3<U>(e1), Vec3<U>(e2), Vec3<U>(n)};
    }
  };

  template <class T>
  [[nodiscard]] static Prepared<T> prepare(const Triangle<T>& t) {
    const Vec3<T> e1 = t.a - t.b, e2 = t.c - t.a;
    return {t.a, e1, e2, cross(e2, e1)};
  }

  template <class T>
  [[nodiscard]] static std::optional<TriangleHit<T>> intersect(const Ray<T>& ray, const Prepared<T>& tri) {
    const T inverse = T(1) / dot(ray.direction, tri.n);
    const Vec3<T> to_plane = tri.v0 - ray.origin;
    const T t = dot(to_plane, tri.n) * inverse;
    if (!(t > 0 && t < std::numeric_limits<T>::infinity())) return std::nullopt;
    const Vec3<T> s = cross(to_plane, ray.direction);
    const T beta = dot(s, tri.e2) * inverse;
    if (!(beta >= 0)) return std::nullopt;
    const T gamma = dot(s, tri.e1) * inverse;
    if (!(gamma >= 0 && beta + gamma <= 1)) return std::nullopt;
    return TriangleHit<T>{t, beta, gamma};
  }

  /// The formula for the study: what `intersect` computes.
  template <class V>
  class Terms {
   public:
    Terms(const Ray<V>& ray, const Prepared<V>& tri)
        : direction_(ray.direction), to_plane_(tri.v0 - ray.origin), e1_(tri.e1), e2_(tri.e2), n_(tri.n) {}

    [[nodiscard]] V det() const { return dot(direction_, n_); }
    [[nodiscard]] V t() const { return dot(to_plane_, n_); }
    [[nodiscard]] V beta() const { return dot(s(), e2_); }
    [[nodiscard]] V gamma() const { return dot(s(), e1_); }

   private:
    [[nodiscard]] Vec3<V> s() const { return cross(to_plane_, direction_); }

    Vec3<V> direction_, to_plane_, e1_, e2_, n_;
  };
};

}  // namespace raysweep
