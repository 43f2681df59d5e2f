// A scene's shapes in one precision, prepared for one intersection method, under one numbering.
#pragma once

#include <vector>

#include "tracer/accel/hit.h"
#include "tracer/accel/triangles.h"
#include "tracer/for_each.h"
#include "tracer/intersect/intersector.h"
#include "tracer/intersect/plane.h"
#include "tracer/intersect/sphere.h"
#include "tracer/scene/scene.h"
#include "tracer/unset_memory.h"

namespace raysweep {

template <class T>
[[nodiscard]] Box<T> box_around(const SphereShape<T>& s) {
  const Vec3<T> r(s.radius, s.radius, s.radius);
  Box<T> box;
  box.include(s.centre - r);
  box.include(s.centre + r);
  return padded(box);
}

/// Ids count planes first, then spheres, then the triangles of one mesh after the other. Spheres and
/// triangles are bounded: they have a box and live in a hierarchy, where item `i` is primitive
/// `first_sphere() + i`. `Triangles` keeps the triangles.
template <class T, class Method, class Triangles = CompactTriangles<T>>
class Primitives {
 public:
  using Prepared = typename Method::template Prepared<T>;

  /// `for_each` shares the work. `boxes` get what `boxes()` gives, which is quicker found on the way.
  explicit Primitives(const Scene& scene, const ForEach& for_each = one_after_the_other,
                      UnsetVector<Box<T>>* boxes = nullptr);

  [[nodiscard]] uint32_t first_sphere() const { return first_sphere_; }
  [[nodiscard]] uint32_t first_triangle() const { return first_triangle_; }
  [[nodiscard]] uint32_t count() const {
    return first_triangle() + static_cast<uint32_t>(triangles_.count());
  }
  [[nodiscard]] uint32_t sphere_count() const { return first_triangle_ - first_sphere_; }
  [[nodiscard]] uint32_t material(uint32_t id) const { return materials_[id]; }
  /// Whether a ray can meet this primitive in two places.
  [[nodiscard]] bool is_met_twice(uint32_t id) const { return id >= first_sphere() && id < first_triangle(); }
  [[nodiscard]] Prepared triangle(uint32_t id) const {
    return Method::template prepare<T>(triangles_.corners(id - first_triangle()));
  }
  [[nodiscard]] Box<T> box(uint32_t id) const {
    return id < first_triangle() ? box_around(spheres_[id - first_sphere()])
                                 : triangles_.box(id - first_triangle());
  }
  /// Of spheres and triangles, for builders of hierarchies: kept nowhere.
  [[nodiscard]] UnsetVector<Box<T>> boxes() const;
  [[nodiscard]] const SphereShape<T>& sphere_shape(uint32_t id) const {
    return spheres_[id - first_sphere()];
  }
  [[nodiscard]] decltype(auto) triangle_shape(uint32_t id) const {
    return triangles_.shape(id - first_triangle());
  }

  /// The first distance to plane `id` that comes after `after`.
  [[nodiscard]] std::optional<T> intersect_plane(uint32_t id, const Ray<T>& ray, const Hit<T>& after) const {
    const PlaneShape<T>& p = planes_[id];
    const auto t = raysweep::intersect_plane(ray, p.normal, p.offset);
    if (!t || !after.before({*t, id})) return std::nullopt;
    return t;
  }

  /// The first distance to sphere `id`, accepted by its box, that comes after `after`.
  [[nodiscard]] std::optional<T> intersect_sphere(uint32_t id, const Ray<T>& ray, const SlabRay<T>& slab_ray,
                                                  const Hit<T>& after) const {
    const SphereShape<T>& s = spheres_[id - first_sphere()];
    const auto hit = raysweep::intersect_sphere(ray, s.centre, s.radius);
    if (!hit) return std::nullopt;
    const Box<T> box = box_around(s);
    const auto enter = accept(box, {hit->enter, id}, slab_ray, after);
    return enter ? enter : accept(box, {hit->leave, id}, slab_ray, after);
  }

  /// The distance to a triangle whose prepared data is at hand, accepted by its box, if it comes after
  /// `after`.
  [[nodiscard]] std::optional<T> intersect_triangle(uint32_t id, const Prepared& prepared, const Ray<T>& ray,
                                                    const SlabRay<T>& slab_ray, const Hit<T>& after) const {
    const auto hit = Method::intersect(ray, prepared);
    return hit ? accept_triangle(id, hit->t, ray, slab_ray, after) : std::nullopt;
  }

  /// The distance at which triangle `id` counts as hit if its method found it at `t`: for methods that ran
  /// elsewhere. There, watertight ones leave a triangle where floats cannot decide, at NaN, to this one here.
  [[nodiscard]] std::optional<T> accept_triangle(uint32_t id, T t, const Ray<T>& ray,
                                                 const SlabRay<T>& slab_ray, const Hit<T>& after) const {
    if (Method::is_watertight && std::isnan(t))
      return intersect_triangle(id, triangle(id), ray, slab_ray, after);
    const auto& shape = triangle_shape(id);
    if (!shape.is_ahead_of(ray) && !(Method::is_watertight && shape.has_all_corners_ahead_of(ray)))
      return std::nullopt;
    return accept(triangles_.box(id - first_triangle()), {t, id}, slab_ray, after);
  }

  /// The surface at `hit`, which must be one of `ray`'s.
  [[nodiscard]] Surface<T> surface(const Ray<T>& ray, const Hit<T>& hit) const {
    if (hit.id < first_sphere()) return planes_[hit.id].surface(ray, hit.t);
    if (hit.id < first_triangle()) return spheres_[hit.id - first_sphere()].surface(ray, hit.t);
    const auto& shape = triangle_shape(hit.id);
    const auto where = Method::intersect(ray, Method::template prepare<T>(shape.corners));
    return shape.surface(ray, where->beta, where->gamma);
  }

  /// How far `point` is from the surface of primitive `id`, triangles taken as their whole planes.
  [[nodiscard]] T distance(uint32_t id, const Vec3<T>& point) const {
    if (id < first_sphere()) return std::abs(planes_[id].signed_distance(point));
    if (id < first_triangle()) return std::abs(spheres_[id - first_sphere()].signed_distance(point));
    return std::abs(triangle_shape(id).signed_distance(point));
  }

 private:
  /// A hit counts where the ray meets the primitive's own box, and its distance is held inside that box. The
  /// true hit lies there, so this only takes rounding away; and since every box of a hierarchy encloses the
  /// boxes below it and `slab` is monotone, no traversal can cut such a hit off: brute force and every
  /// hierarchy agree exactly, also one that cuts the box into pieces (`build_sbvh`).
  [[nodiscard]] static std::optional<T> accept(const Box<T>& box, const Hit<T>& hit,
                                               const SlabRay<T>& slab_ray, const Hit<T>& after) {
    if (!(hit.t > 0)) return std::nullopt;
    const Interval<T> inside = slab(box, slab_ray);
    const T held = std::min(std::max(hit.t, inside.enter), inside.leave);
    if (inside.empty() || !after.before({held, hit.id})) return std::nullopt;
    return held;
  }

  uint32_t first_sphere_, first_triangle_;  // at hand: they are asked for at every hit
  std::vector<PlaneShape<T>> planes_;
  std::vector<SphereShape<T>> spheres_;
  Triangles triangles_;
  UnsetVector<uint32_t> materials_;  // of each primitive
};

inline constexpr size_t primitives_at_once = 1024;  // take some 20 µs

template <class T, class Method, class Triangles>
Primitives<T, Method, Triangles>::Primitives(const Scene& scene, const ForEach& for_each,
                                             UnsetVector<Box<T>>* boxes)
    : first_sphere_(static_cast<uint32_t>(scene.planes.size())),
      first_triangle_(first_sphere_ + static_cast<uint32_t>(scene.spheres.size())) {
  for (const Plane& p : scene.planes) {
    planes_.emplace_back(p);
    materials_.push_back(p.material);
  }
  for (const Sphere& s : scene.spheres) {
    spheres_.emplace_back(s);
    materials_.push_back(s.material);
  }
  std::vector<MeshPiece> pieces;
  size_t triangles = 0, vertices = 0;
  for (const Mesh& mesh : scene.meshes) {
    const size_t count = mesh.triangles.size();
    for (size_t begin = 0; begin < count; begin += primitives_at_once)
      pieces.push_back({&mesh, begin, std::min(begin + primitives_at_once, count), triangles, vertices});
    triangles += count;
    vertices += mesh.vertices.size();
  }
  triangles_.resize(triangles, vertices);
  materials_.resize(first_triangle() + triangles);
  Box<T>* triangle_boxes = nullptr;
  if (boxes != nullptr) {
    boxes->resize(sphere_count() + triangles);
    for (size_t i = 0; i < spheres_.size(); ++i) (*boxes)[i] = box_around(spheres_[i]);
    triangle_boxes = boxes->data() + sphere_count();
  }
  for_each(pieces.size(), [&](size_t i) {
    const MeshPiece& piece = pieces[i];
    triangles_.fill(piece, triangle_boxes);
    const auto first =
        materials_.begin() + first_triangle() + static_cast<std::ptrdiff_t>(piece.first_triangle);
    std::fill(first + static_cast<std::ptrdiff_t>(piece.begin),
              first + static_cast<std::ptrdiff_t>(piece.end), piece.mesh->material);
  });
}

template <class T, class Method, class Triangles>
UnsetVector<Box<T>> Primitives<T, Method, Triangles>::boxes() const {
  UnsetVector<Box<T>> all(count() - first_sphere());
  for (uint32_t i = 0; i < all.size(); ++i) all[i] = box(first_sphere() + i);
  return all;
}

}  // namespace raysweep
