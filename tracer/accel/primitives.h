// A scene's shapes in one precision, prepared for one intersection method, under one numbering.
#pragma once

#include <span>
#include <vector>

#include "tracer/accel/hit.h"
#include "tracer/accel/surface.h"
#include "tracer/for_each.h"
#include "tracer/intersect/intersector.h"
#include "tracer/intersect/plane.h"
#include "tracer/intersect/sphere.h"
#include "tracer/scene/scene.h"
#include "tracer/unset_memory.h"

namespace raysweep {

/// Ids count planes first, then spheres, then the triangles of one mesh after the other. Spheres and
/// triangles are bounded: they have a box and live in a hierarchy, where item `i` is primitive
/// `first_sphere() + i`.
template <class T, class Method>
class Primitives {
 public:
  using Prepared = typename Method::template Prepared<T>;

  /// `for_each` shares the work.
  explicit Primitives(const Scene& scene, const ForEach& for_each = one_after_the_other);

  [[nodiscard]] uint32_t first_sphere() const { return static_cast<uint32_t>(planes_.size()); }
  [[nodiscard]] uint32_t first_triangle() const {
    return static_cast<uint32_t>(planes_.size() + spheres_.size());
  }
  [[nodiscard]] uint32_t count() const { return first_sphere() + static_cast<uint32_t>(boxes_.size()); }
  [[nodiscard]] std::span<const Box<T>> boxes() const { return boxes_; }
  [[nodiscard]] uint32_t material(uint32_t id) const { return materials_[id]; }
  /// Whether a ray can meet this primitive in two places.
  [[nodiscard]] bool is_met_twice(uint32_t id) const { return id >= first_sphere() && id < first_triangle(); }
  [[nodiscard]] const Prepared& triangle(uint32_t id) const { return prepared_[id - first_triangle()]; }
  [[nodiscard]] const Box<T>& box(uint32_t id) const { return boxes_[id - first_sphere()]; }
  [[nodiscard]] const SphereShape<T>& sphere_shape(uint32_t id) const {
    return spheres_[id - first_sphere()];
  }
  [[nodiscard]] const TriangleShape<T>& triangle_shape(uint32_t id) const {
    return triangles_[id - first_triangle()];
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
    const auto enter = accept(id, hit->enter, slab_ray, after);
    return enter ? enter : accept(id, hit->leave, slab_ray, after);
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
    const TriangleShape<T>& shape = triangles_[id - first_triangle()];
    if (!shape.is_ahead_of(ray) && !(Method::is_watertight && shape.has_all_corners_ahead_of(ray)))
      return std::nullopt;
    return accept(id, t, slab_ray, after);
  }

  /// The surface at `hit`, which must be one of `ray`'s.
  [[nodiscard]] Surface<T> surface(const Ray<T>& ray, const Hit<T>& hit) const {
    if (hit.id < first_sphere()) return planes_[hit.id].surface(ray, hit.t);
    if (hit.id < first_triangle()) return spheres_[hit.id - first_sphere()].surface(ray, hit.t);
    const auto where = Method::intersect(ray, triangle(hit.id));
    return triangles_[hit.id - first_triangle()].surface(ray, where->beta, where->gamma);
  }

  /// How far `point` is from the surface of primitive `id`, triangles taken as their whole planes.
  [[nodiscard]] T distance(uint32_t id, const Vec3<T>& point) const {
    if (id < first_sphere()) return std::abs(planes_[id].signed_distance(point));
    if (id < first_triangle()) return std::abs(spheres_[id - first_sphere()].signed_distance(point));
    return std::abs(triangles_[id - first_triangle()].signed_distance(point));
  }

 private:
  /// A hit counts where the ray meets the primitive's own box, and its distance is held inside that box. The
  /// true hit lies there, so this only takes rounding away; and since every box of a hierarchy encloses the
  /// boxes below it and `slab` is monotone, no traversal can cut such a hit off: brute force and every
  /// hierarchy agree exactly.
  [[nodiscard]] std::optional<T> accept(uint32_t id, T t, const SlabRay<T>& slab_ray,
                                        const Hit<T>& after) const {
    if (!(t > 0)) return std::nullopt;
    const Interval<T> inside = slab(boxes_[id - first_sphere()], slab_ray);
    const T held = std::min(std::max(t, inside.enter), inside.leave);
    if (inside.empty() || !after.before({held, id})) return std::nullopt;
    return held;
  }

  void set_triangles(const Mesh& mesh, size_t begin, size_t end, size_t first);

  std::vector<PlaneShape<T>> planes_;
  std::vector<SphereShape<T>> spheres_;
  UnsetVector<TriangleShape<T>> triangles_;
  UnsetVector<Prepared> prepared_;
  UnsetVector<Box<T>> boxes_;
  UnsetVector<uint32_t> materials_;  // of each primitive
};

/// By how much of their largest coordinate boxes are grown: computed hits stray a few units in the last place
/// from the surface.
template <class T>
inline constexpr T box_padding = 4 * std::numeric_limits<T>::epsilon();

template <class T>
[[nodiscard]] Box<T> padded(const Box<T>& box) {
  const T by = box_padding<T> * std::max(max_abs(box.lower()), max_abs(box.upper()));
  const Vec3<T> pad(by, by, by);
  Box<T> grown;
  grown.bounds[0] = box.lower() - pad;
  grown.bounds[1] = box.upper() + pad;
  return grown;
}

template <class T, class Method>
Primitives<T, Method>::Primitives(const Scene& scene, const ForEach& for_each) {
  for (const Plane& p : scene.planes) {
    planes_.emplace_back(p);
    materials_.push_back(p.material);
  }
  for (const Sphere& s : scene.spheres) {
    const SphereShape<T> shape(s);
    const Vec3<T> r(shape.radius, shape.radius, shape.radius);
    Box<T> box;
    box.include(shape.centre - r);
    box.include(shape.centre + r);
    spheres_.push_back(shape);
    boxes_.push_back(padded(box));
    materials_.push_back(s.material);
  }
  constexpr size_t chunk_size = 4096;  // takes a tenth of a millisecond
  struct Chunk {
    const Mesh* mesh;
    size_t begin, first;  // in the mesh, of all triangles
  };
  std::vector<Chunk> chunks;
  size_t count = 0;
  for (const Mesh& mesh : scene.meshes) {
    for (size_t begin = 0; begin < mesh.triangles.size(); begin += chunk_size)
      chunks.push_back({&mesh, begin, count + begin});
    count += mesh.triangles.size();
  }
  prepared_.resize(count);
  triangles_.resize(count);
  boxes_.resize(spheres_.size() + count);
  materials_.resize(first_triangle() + count);
  for_each(chunks.size(), [&](size_t i) {
    const auto& [mesh, begin, first] = chunks[i];
    set_triangles(*mesh, begin, std::min(begin + chunk_size, mesh->triangles.size()), first);
  });
}

/// The triangles `begin … end` of `mesh`; the first of them is number `first` of all.
template <class T, class Method>
void Primitives<T, Method>::set_triangles(const Mesh& mesh, size_t begin, size_t end, size_t first) {
  for (size_t i = begin; i < end; ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    const Triangle<T> t{Vec3<T>(mesh.vertices[a]), Vec3<T>(mesh.vertices[b]), Vec3<T>(mesh.vertices[c])};
    Box<T> box;
    box.include(t.a);
    box.include(t.b);
    box.include(t.c);
    const size_t at = first + i - begin;
    prepared_[at] = Method::template prepare<T>(t);
    triangles_[at] = TriangleShape<T>(t);
    boxes_[spheres_.size() + at] = padded(box);
    materials_[first_triangle() + at] = mesh.material;
  }
}

}  // namespace raysweep
