// Points on surfaces, with a proven bound on how far rounding leaves them off, so that rays can start there.
//
// Notation: u is half an ulp of 1, γ(n) = nu/(1 − nu) bounds n roundings (Higham 2002; pbrt-v4, 6.8). Every
// shape has a *clearance* δ: a point of `surface`, moved by δ along the normal, lies on that side of the
// shape for the very computation that intersection decides sides by, rounding included. So a ray that starts
// there and heads away never meets the shape again, and nothing farther than δ is jumped over. No absolute or
// tuned epsilon takes part: clearances scale with coordinates.
#pragma once

#include "tracer/accel/triangle_face.h"
#include "tracer/scene/scene.h"

namespace raysweep {

/// Where a ray meets a shape.
template <class T>
struct Surface {
  Vec3<T> point, normal;  // the unit normal faces the ray
  T clearance;            // how far along ± the normal a ray from here must start
  bool against;           // the ray runs against the shape's own normal: outside in, where it has an inside
};

/// The surface with its own normal turned to face the ray.
template <class T>
[[nodiscard]] Surface<T> facing(const Vec3<T>& point, const Vec3<T>& own_normal, T clearance,
                                const Vec3<T>& direction) {
  const bool against = !(dot(own_normal, direction) > 0);
  return {point, against ? own_normal : -own_normal, clearance, against};
}

template <class T>
struct PlaneShape {
  Vec3<T> normal;
  T offset;

  explicit PlaneShape(const Plane& p) : normal(p.normal), offset(static_cast<T>(p.offset)) {}

  [[nodiscard]] T signed_distance(const Vec3<T>& p) const { return dot(normal, p) + offset; }

  /// The hit is projected onto the plane, which takes away all error of `t` but its square. What is left is ×
  /// Σ|n|p: the products and sums of the distance, before and after (3 roundings each; adding D is exact so
  /// close to the plane), and rounding the point and the ray's start (1 each); 2 for the second order.
  [[nodiscard]] Surface<T> surface(const Ray<T>& ray, T t) const {
    Vec3<T> p = ray.at(t);
    p = p - normal * signed_distance(p);
    return facing(p, normal, gamma_bound<T>(10) * abs_dot(normal, p), ray.direction);
  }
};

template <class T>
struct SphereShape {
  Vec3<T> centre;
  T radius;

  explicit SphereShape(const Sphere& s) : centre(s.centre), radius(static_cast<T>(s.radius)) {}

  [[nodiscard]] T signed_distance(const Vec3<T>& p) const { return length(p - centre) - radius; }

  /// The point is the centre plus radius × normal: its distance from the centre is right to the normal's
  /// length (5 roundings), their product (1), and adding the centre (1 on |C| + r, √3 for three axes, and
  /// once more for the start of the ray). Intersection decides by |O−C|² − r²: 5 more on r².
  [[nodiscard]] Surface<T> surface(const Ray<T>& ray, T t) const {
    const Vec3<T> normal = normalize(ray.at(t) - centre);
    const T clearance = gamma_bound<T>(16) * radius + gamma_bound<T>(6) * max_abs(centre);
    return facing(centre + radius * normal, normal, clearance, ray.direction);
  }
};

/// A triangle's corners and plane. Intersection methods find where a ray passes; on which side of the plane
/// it started is decided here, once for all methods, so that it is certain for rays that start on the
/// surface.
template <class T>
struct TriangleShape {
  Triangle<T> corners;
  Vec3<T> normal;
  T clearance;
  T inset;  // the widest of all edges: see inset_from

  explicit TriangleShape(const Triangle<T>& t) : TriangleShape(t, faces_of<T, 1>({t})[0]) {}
  /// `face` must be `t`'s.
  TriangleShape(const Triangle<T>& t, const TriangleFace<T>& face)
      : corners(t), normal(face.normal), clearance(face.clearance), inset(face.inset) {}

  [[nodiscard]] T signed_distance(const Vec3<T>& p) const { return dot(normal, p - corners.a); }

  [[nodiscard]] bool is_ahead_of(const Ray<T>& ray) const {
    const T side = signed_distance(ray.origin), towards = dot(normal, ray.direction);
    return side > 0 ? towards < 0 : side < 0 && towards > 0;
  }

  /// Whether every corner is ahead of the ray's start along the axis in which its direction is longest: no
  /// rounding takes part. For watertight methods this is enough to be met. `is_ahead_of` knows nothing of a
  /// ray that runs in the triangle's plane but for rounding, and such a triangle may be all that is between
  /// its neighbours. A ray that starts on the triangle and heads away has a corner behind it: the inset keeps
  /// its start farther from the edges than the clearance lifts it.
  [[nodiscard]] bool has_all_corners_ahead_of(const Ray<T>& ray) const {
    const Vec3<T>& d = ray.direction;
    const int axis = longest_axis(d);
    const auto is_ahead = [&](const Vec3<T>& corner) {
      return d[axis] > 0 ? corner[axis] > ray.origin[axis] : corner[axis] < ray.origin[axis];
    };
    return has_area() && is_ahead(corners.a) && is_ahead(corners.b) && is_ahead(corners.c);
  }

  /// A triangle without area is no surface, and is never met.
  [[nodiscard]] bool has_area() const { return !(normal == Vec3<T>()); }

  /// The point from barycentric coordinates: off the plane by rounding of the corners' sum alone, however far
  /// the ray came. Next to an edge it is moved inwards by a few clearances, lest a ray that starts off this
  /// face starts on the wrong side of the neighbouring one.
  [[nodiscard]] Surface<T> surface(const Ray<T>& ray, T beta, T gamma) const {
    const T alpha = 1 - beta - gamma;
    Vec3<T> p = corners.a * alpha + corners.b * beta + corners.c * gamma;
    if (!(alpha >= inset && beta >= inset && gamma >= inset))
      p = stepped_inwards(p, corners, clearance, {alpha, beta, gamma});
    return facing(p, normal, clearance, ray.direction);
  }

 private:
  /// `p`, whose barycentric coordinates are `at`. Kept out of the way of the many hits that lie elsewhere,
  /// and handed copies, so that shapes which nobody keeps need no place in memory.
  [[gnu::noinline]] static Vec3<T> stepped_inwards(Vec3<T> p, Triangle<T> corners, T clearance, Vec3<T> at) {
    const TriangleExtents<T, 1> extents({corners});
    const auto least = [&](size_t corner) {
      return inset_from(extents.edge[corner][0], extents.area[0], clearance);
    };
    p += step_from_edge(corners.b, corners.c, corners.a, least(0) - at.x);
    p += step_from_edge(corners.c, corners.a, corners.b, least(1) - at.y);
    p += step_from_edge(corners.a, corners.b, corners.c, least(2) - at.z);
    return p;
  }

  /// `share` of the altitude from the edge PQ to `corner`, at right angles to the edge; nothing if not
  /// positive.
  [[nodiscard]] static Vec3<T> step_from_edge(const Vec3<T>& p, const Vec3<T>& q, const Vec3<T>& corner,
                                              T share) {
    if (!(share > 0)) return {};
    const Vec3<T> edge = q - p, towards = corner - p;
    return (towards - edge * (dot(towards, edge) / dot(edge, edge))) * share;
  }
};

/// `direction`; if it is so flat that its computed cosine with `away` has the wrong sign, lifted by an ulp or
/// two. Chosen number by number, which loops over many can do without a branch.
template <class T>
[[nodiscard]] Vec3<T> lifted(const Vec3<T>& direction, const Vec3<T>& away) {
  const Vec3<T> up = direction + away * (8 * unit_roundoff<T>);
  const bool leaves = dot(away, direction) > 0;
  return {leaves ? direction.x : up.x, leaves ? direction.y : up.y, leaves ? direction.z : up.z};
}

/// Where a ray with `direction` starts that leaves `surface` on the side that `direction` points to,
/// `clearance` away.
template <class T>
[[nodiscard]] Ray<T> spawn(const Surface<T>& surface, const Vec3<T>& direction, bool same_side, T clearance) {
  const Vec3<T> away = same_side ? surface.normal : -surface.normal;
  return {surface.point + away * clearance, lifted(direction, away)};
}

}  // namespace raysweep
