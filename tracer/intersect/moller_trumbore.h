// Möller & Trumbore 1997, "Fast, minimum storage ray/triangle intersection".
#pragma once

#include <limits>

#include "tracer/intersect/intersector.h"

namespace raysweep {

struct MollerTrumbore {
  static constexpr std::string_view name = "moller_trumbore";
  static constexpr std::string_view summary =
      "Moeller & Trumbore 1997; edges precomputed, barycentric tests first";
  static constexpr bool is_watertight = false;

  template <class T>
  struct Prepared {
    Vec3<T> a, ab, ac;
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
};

}  // namespace raysweep
