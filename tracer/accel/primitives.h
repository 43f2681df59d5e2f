// A scene's shapes in one precision, prepared for one intersection method, under one numbering.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tracer/intersect/intersector.h"
#include "tracer/scene/scene.h"

namespace raysweep {

/// The nearest thing that a ray meets: at distance `t`, with primitive id `id`.
template <class T>
struct Hit {
  T t;
  uint32_t id;

  /// The one rule of all cores: of two hits at equal `t` the lower id wins.
  [[nodiscard]] bool before(const Hit& other) const { return t < other.t || (t == other.t && id < other.id); }
  /// What every hit comes before.
  [[nodiscard]] static Hit none() { return {std::numeric_limits<T>::infinity(), ~0u}; }
  [[nodiscard]] bool is_none() const { return id == ~0u; }
};

template <class T>
[[nodiscard]] std::optional<T> intersect_plane(const Ray<T>& ray, const Vec3<T>& normal, T offset) {
  const T t = -(dot(normal, ray.origin) + offset) / dot(normal, ray.direction);
  if (!(t > 0 && t < std::numeric_limits<T>::infinity())) return std::nullopt;
  return t;
}

/// The smallest positive root. The discriminant is taken from the distance between centre and ray, and the
/// second root from the product of both, so that far and small spheres keep their digits (Haines, Günther &
/// Akenine-Möller 2019, "Precision improvements for ray/sphere intersection").
template <class T>
[[nodiscard]] std::optional<T> intersect_sphere(const Ray<T>& ray, const Vec3<T>& centre, T radius) {
  const Vec3<T> f = ray.origin - centre;
  const T a = dot(ray.direction, ray.direction);
  const T b = -dot(f, ray.direction);
  const Vec3<T> from_centre = f + (b / a) * ray.direction;
  const T discriminant = radius * radius - dot(from_centre, from_centre);
  if (!(discriminant >= 0)) return std::nullopt;
  const T q = b + std::copysign(std::sqrt(a * discriminant), b);
  const T t0 = (dot(f, f) - radius * radius) / q, t1 = q / a;
  const T low = std::min(t0, t1), high = std::max(t0, t1);
  if (low > 0) return low;
  if (high > 0) return high;
  return std::nullopt;
}

/// Ids count planes first, then spheres, then the triangles of one mesh after the other. Spheres and
/// triangles are bounded: they have a box and live in a hierarchy, where item `i` is primitive
/// `first_sphere() + i`.
template <class T, class Method>
class Primitives {
 public:
  using Prepared = typename Method::template Prepared<T>;

  explicit Primitives(const Scene& scene);

  [[nodiscard]] uint32_t first_sphere() const { return static_cast<uint32_t>(planes_.size()); }
  [[nodiscard]] uint32_t first_triangle() const {
    return static_cast<uint32_t>(planes_.size() + spheres_.size());
  }
  [[nodiscard]] uint32_t count() const { return first_sphere() + static_cast<uint32_t>(boxes_.size()); }
  [[nodiscard]] const std::vector<Box<T>>& boxes() const { return boxes_; }
  [[nodiscard]] uint32_t material(uint32_t id) const { return materials_[id]; }
  [[nodiscard]] const Prepared& triangle(uint32_t id) const { return triangles_[id - first_triangle()]; }

  [[nodiscard]] std::optional<T> intersect_plane(uint32_t id, const Ray<T>& ray) const {
    return raysweep::intersect_plane(ray, planes_[id].normal, planes_[id].offset);
  }

  /// The distance to sphere `id`, accepted by its box.
  [[nodiscard]] std::optional<T> intersect_sphere(uint32_t id, const Ray<T>& ray,
                                                  const SlabRay<T>& slab_ray) const {
    const SphereData& s = spheres_[id - first_sphere()];
    return accept(id, raysweep::intersect_sphere(ray, s.centre, s.radius), slab_ray);
  }

  /// The distance to a triangle whose prepared data is at hand, accepted by its box.
  [[nodiscard]] std::optional<T> intersect_triangle(uint32_t id, const Prepared& prepared, const Ray<T>& ray,
                                                    const SlabRay<T>& slab_ray) const {
    const auto hit = Method::intersect(ray, prepared);
    if (!hit) return std::nullopt;
    return accept(id, hit->t, slab_ray);
  }

  /// The surface at `hit`: the point (moved onto the surface where that is cheap) and the unit normal that
  /// faces the ray.
  struct Surface {
    Vec3<T> point, normal;
  };
  [[nodiscard]] Surface surface(const Ray<T>& ray, const Hit<T>& hit) const;

 private:
  struct PlaneData {
    Vec3<T> normal;
    T offset;
  };
  struct SphereData {
    Vec3<T> centre;
    T radius;
  };

  /// A hit counts where the ray meets the primitive's own box, and its distance is held inside that box. The
  /// true hit lies there, so this only takes rounding away; and since every box of a hierarchy encloses the
  /// boxes below it and `slab` is monotone, no traversal can cut such a hit off: brute force and every
  /// hierarchy agree exactly.
  [[nodiscard]] std::optional<T> accept(uint32_t id, std::optional<T> t, const SlabRay<T>& slab_ray) const {
    if (!t) return std::nullopt;
    const Interval<T> inside = slab(boxes_[id - first_sphere()], slab_ray);
    const T held = std::min(std::max(*t, inside.enter), inside.leave);
    if (inside.empty() || !(held > 0)) return std::nullopt;
    return held;
  }

  std::vector<PlaneData> planes_;
  std::vector<SphereData> spheres_;
  std::vector<Prepared> triangles_;
  std::vector<Vec3<T>> triangle_normals_;
  std::vector<Box<T>> boxes_;
  std::vector<uint32_t> materials_;
};

/// `box` grown by a few units in the last place of its coordinates: computed hits stray that far from the
/// surface.
template <class T>
[[nodiscard]] Box<T> padded(const Box<T>& box) {
  constexpr T ulps = 4 * std::numeric_limits<T>::epsilon();
  const T by = ulps * std::max(max_abs(box.lower()), max_abs(box.upper()));
  const Vec3<T> pad(by, by, by);
  Box<T> grown;
  grown.bounds[0] = box.lower() - pad;
  grown.bounds[1] = box.upper() + pad;
  return grown;
}

template <class T, class Method>
Primitives<T, Method>::Primitives(const Scene& scene) {
  for (const Plane& p : scene.planes) {
    planes_.push_back({Vec3<T>(p.normal), static_cast<T>(p.offset)});
    materials_.push_back(p.material);
  }
  for (const Sphere& s : scene.spheres) {
    const SphereData data{Vec3<T>(s.centre), static_cast<T>(s.radius)};
    const Vec3<T> r(data.radius, data.radius, data.radius);
    Box<T> box;
    box.include(data.centre - r);
    box.include(data.centre + r);
    spheres_.push_back(data);
    boxes_.push_back(padded(box));
    materials_.push_back(s.material);
  }
  for (const Mesh& mesh : scene.meshes) {
    for (const auto& [a, b, c] : mesh.triangles) {
      const Triangle<T> t{Vec3<T>(mesh.vertices[a]), Vec3<T>(mesh.vertices[b]), Vec3<T>(mesh.vertices[c])};
      Box<T> box;
      box.include(t.a);
      box.include(t.b);
      box.include(t.c);
      triangles_.push_back(Method::template prepare<T>(t));
      // In double: in float the squares of a triangle of size 1e-10 are 0.
      const Vec3d n = cross(Vec3d(t.b) - Vec3d(t.a), Vec3d(t.c) - Vec3d(t.a));
      const double size = length(n);
      triangle_normals_.push_back(size > 0 ? Vec3<T>(n * (1 / size)) : Vec3<T>(0, 1, 0));
      boxes_.push_back(padded(box));
      materials_.push_back(mesh.material);
    }
  }
}

template <class T, class Method>
auto Primitives<T, Method>::surface(const Ray<T>& ray, const Hit<T>& hit) const -> Surface {
  Vec3<T> point = ray.at(hit.t);
  Vec3<T> normal;
  if (hit.id < first_sphere()) {
    normal = planes_[hit.id].normal;
  } else if (hit.id < first_triangle()) {
    const SphereData& s = spheres_[hit.id - first_sphere()];
    normal = normalize(point - s.centre);
    point = s.centre + s.radius * normal;
  } else {
    normal = triangle_normals_[hit.id - first_triangle()];
  }
  return {point, dot(normal, ray.direction) > 0 ? -normal : normal};
}

}  // namespace raysweep
