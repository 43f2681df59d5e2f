// Kensler & Shirley 2006, "Optimizing ray–triangle intersection via automated search".
#pragma once

#include "tracer/intersect/formula.h"

namespace raysweep {

/// Morozov's formula (10) is this with other signs, answer for answer: where their times differ, the compiler
/// does.
struct KenslerShirley {
  static constexpr std::string_view name = "kensler_shirley";
  static constexpr std::string_view summary =
      "Kensler & Shirley 2006; normal and edges precomputed, distance first";
  static constexpr bool is_watertight = false;
  static constexpr bool gives_weights = true;
  static constexpr Division division = Division::early;
  static constexpr Order order = Order::distance_first;

  template <class T>
  struct Prepared {
    Vec3<T> a, ab, ca, n;

    template <class U>
    [[nodiscard]] Prepared<U> as() const {
      return {Vec3<U>(a), Vec3<U>(ab), Vec3<U>(ca), Vec3<U>(n)};
    }
  };

  template <class T>
  [[nodiscard]] static Prepared<T> prepare(const Triangle<T>& t) {
    const Vec3<T> ab = t.b - t.a, ca = t.a - t.c;
    return {t.a, ab, ca, cross(ab, ca)};
  }

  template <class V>
  class Terms {
   public:
    Terms(const Ray<V>& ray, const Prepared<V>& tri)
        : direction_(ray.direction), oa_(tri.a - ray.origin), ab_(tri.ab), ca_(tri.ca), n_(tri.n) {}

    [[nodiscard]] V det() const { return dot(direction_, n_); }
    [[nodiscard]] V t() const { return dot(n_, oa_); }
    [[nodiscard]] V beta() const { return dot(i(), ca_); }
    [[nodiscard]] V gamma() const { return dot(i(), ab_); }

   private:
    [[nodiscard]] Vec3<V> i() const { return cross(oa_, direction_); }

    Vec3<V> direction_, oa_, ab_, ca_, n_;
  };
};

}  // namespace raysweep
