// The distance to a plane, for formulas that look for the point in it first.
#pragma once

#include "tracer/intersect/formula.h"

namespace raysweep {

/// The plane normal·X = offset.
template <class T>
struct TrianglePlane {
  Vec3<T> normal;
  T offset;

  template <class U>
  [[nodiscard]] TrianglePlane<U> as() const {
    return {Vec3<U>(normal), static_cast<U>(offset)};
  }
};

/// The triangle's plane; the normal is AB×AC.
template <class T>
[[nodiscard]] TrianglePlane<T> plane_of(const Triangle<T>& t) {
  const Vec3<T> n = cross(t.b - t.a, t.c - t.a);
  return {n, dot(n, t.a)};
}

/// The value of normal·X − offset·w at the point X/w.
template <class V>
[[nodiscard]] V side_of(const TrianglePlane<V>& plane, const Vec3<V>& x, const V& w) {
  return dot(plane.normal, x) - plane.offset * w;
}

/// Terms of a method whose constants have a member `plane`.
template <class V, class Prepared>
class PlaneTerms {
 public:
  PlaneTerms(const Ray<V>& ray, const Prepared& tri) : tri_(tri), ray_(ray) {}

  [[nodiscard]] V det() const { return dot(tri_.plane.normal, ray_.direction); }
  [[nodiscard]] V t() const { return tri_.plane.offset - dot(tri_.plane.normal, ray_.origin); }

 protected:
  [[nodiscard]] const Prepared& tri() const { return tri_; }
  /// w times the point at t/w.
  [[nodiscard]] Vec3<V> point(const V& t, const V& w) const { return ray_.origin * w + ray_.direction * t; }

 private:
  Prepared tri_;
  Ray<V> ray_;
};

}  // namespace raysweep
