#include "tracer/peers/embree_shapes.h"

namespace raysweep {

namespace {

Scene without_meshes(const Scene& scene) {
  Scene others;
  others.planes = scene.planes;
  others.spheres = scene.spheres;
  return others;
}

/// Into 0 … `most`; what is no number becomes 0.
float held(float coordinate, float most) { return coordinate > 0 ? std::min(coordinate, most) : 0; }

}  // namespace

EmbreeShapes::EmbreeShapes(const Scene& scene) : others_(without_meshes(scene)) {
  for (const Mesh& mesh : scene.meshes) {
    for (const auto& [a, b, c] : mesh.triangles) {
      const Triangle<float> t{Vec3f(mesh.vertices[a]), Vec3f(mesh.vertices[b]), Vec3f(mesh.vertices[c])};
      triangles_.emplace_back(t);
      prepared_.push_back(MollerTrumbore::prepare(t));
      materials_.push_back(mesh.material);
    }
  }
}

Hit<float> EmbreeShapes::nearest_other(const Ray<float>& ray, const Hit<float>& limit) const {
  Hit<float> nearest = limit;
  const auto keep = [&](std::optional<float> t, uint32_t id) {
    if (t && Hit<float>{*t, id}.before(nearest)) nearest = {*t, id};
  };
  for (uint32_t id = 0; id < others_.first_sphere(); ++id)
    keep(others_.intersect_plane(id, ray, Hit<float>::start()), id);
  if (others_.first_sphere() == others_.count()) return nearest;
  const SlabRay<float> slab_ray(ray);
  for (uint32_t id = others_.first_sphere(); id < first_triangle(); ++id)
    keep(others_.intersect_sphere(id, ray, slab_ray, Hit<float>::start()), id);
  return nearest;
}

/// By the coordinates that Möller & Trumbore's method refuses, held inside the triangle.
Surface<float> EmbreeShapes::surface_beside(const Ray<float>& ray, uint32_t index) const {
  const auto& triangle = prepared_[index];
  const Vec3f p = cross(ray.direction, triangle.ac), ao = ray.origin - triangle.a;
  const float inverse = 1 / dot(triangle.ab, p);
  const float beta = held(dot(ao, p) * inverse, 1);
  const float gamma = held(dot(ray.direction, cross(ao, triangle.ab)) * inverse, 1 - beta);
  return triangles_[index].surface(ray, beta, gamma);
}

}  // namespace raysweep
