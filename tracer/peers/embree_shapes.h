// What Embree is not asked for: planes and spheres, and the surface at a hit.
#pragma once

#include "tracer/accel/primitives.h"
#include "tracer/intersect/moller_trumbore.h"

namespace raysweep {

/// A scene's shapes under our own numbering. Shading needs the same of them as in our own tracer, for
/// pictures to differ where hits do and nowhere else.
class EmbreeShapes {
 public:
  explicit EmbreeShapes(const Scene& scene);

  [[nodiscard]] uint32_t first_triangle() const { return others_.first_triangle(); }
  [[nodiscard]] uint32_t material(uint32_t id) const {
    return id < first_triangle() ? others_.material(id) : materials_[id - first_triangle()];
  }

  /// The first plane or sphere that `ray` meets before `limit`.
  [[nodiscard]] Hit<float> nearest_other(const Ray<float>& ray, const Hit<float>& limit) const;

  /// The surface at `hit`, whoever found it. What Embree finds at a triangle's edge our method may not: the
  /// nearest point of the triangle stands for it then.
  [[nodiscard]] Surface<float> surface(const Ray<float>& ray, const Hit<float>& hit) const {
    if (hit.id < first_triangle()) return others_.surface(ray, hit);
    const uint32_t index = hit.id - first_triangle();
    const auto where = MollerTrumbore::intersect(ray, prepared_[index]);
    if (!where) return surface_beside(ray, index);
    return triangles_[index].surface(ray, where->beta, where->gamma);
  }

 private:
  [[nodiscard]] Surface<float> surface_beside(const Ray<float>& ray, uint32_t index) const;

  Primitives<float, MollerTrumbore> others_;  // planes and spheres
  std::vector<TriangleShape<float>> triangles_;
  std::vector<MollerTrumbore::Prepared<float>> prepared_;
  std::vector<uint32_t> materials_;  // of triangles
};

}  // namespace raysweep
