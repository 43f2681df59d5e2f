// Möller & Trumbore 1997, "Fast, minimum storage ray/triangle intersection".
#pragma once

#include <limits>

#include "tracer/intersect/formula.h"

namespace raysweep {

struct MollerTrumbore {
  static constexpr std::string_view name = "moller_trumbore";
  static constexpr std::string_view summary =
      "Moeller & Trumbore 1997; edges precomputed, barycentric tests first";
  static constexpr bool is_watertight = false;
  static constexpr bool gives_weights = true;
  static constexpr Division division = Division::early;
  static constexpr Order order = Order::weights_first;

  template <class T>
  struct Prepared {
    Vec3<T> a, ab, ac;

    template <class U>
    [[nodiscard]] Prepared<U> as() const {
      return {Vec3<U>(a), Vec3<U>(ab), Vec3<U>(ac)};
    }
  };

  template <class T>
  [[nodiscard]] static Prepared<T> prepare(const Triangle<T>& t) {
    return {t.a, t.b - t.a, t.c - t.a};
  }

  template <class T>
  [[nodiscard]] static std::optional<TriangleHit<T>> intersect(const Ray<T>& ray, const Prepared<T>& tri) {
    const Vec3<T> p = cross(ray.direction, tri.ac);
    const T inverse = T(1) / dot(tri.ab, p);
    const Vec3<T> ao = ray.origin - tri.a;
    const T beta = dot(ao, p) * inverse;
    if (!(beta >= 0 && beta <= 1)) return std::nullopt;
    const Vec3<T> q = cross(ao, tri.ab);
    const T gamma = dot(ray.direction, q) * inverse;
    if (!(gamma >= 0 && beta + gamma <= 1)) return std::nullopt;
    const T t = dot(tri.ac, q) * inverse;
    // An infinite t is a ray in the triangle's plane whose determinant rounded to 0.
    if (!(t > 0 && t < std::numeric_limits<T>::infinity())) return std::nullopt;
    return TriangleHit<T>{t, beta, gamma};
  }

  /// The formula for the study: what `intersect` computes.
  template <class V>
  class Terms {
   public:
    Terms(const Ray<V>& ray, const Prepared<V>& tri)
        : direction_(ray.direction), ab_(tri.ab), ac_(tri.ac), ao_(ray.origin - tri.a) {}

    [[nodiscard]] V det() const { return dot(ab_, p()); }
    [[nodiscard]] V t() const { return dot(ac_, q()); }
    [[nodiscard]] V beta() const { return dot(ao_, p()); }
    [[nodiscard]] V gamma() const { return dot(direction_, q()); }

   private:
    [[nodiscard]] Vec3<V> p() const { return cross(direction_, ac_); }
    [[nodiscard]] Vec3<V> q() const { return cross(ao_, ab_); }

    Vec3<V> direction_, ab_, ac_, ao_;
  };
};

}  // namespace raysweep
