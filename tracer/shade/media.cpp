#include "tracer/shade/media.h"

#include <limits>

#include "tracer/scene/solid.h"

namespace raysweep {

namespace {

/// Something transparent: a half-space, a sphere, or a connected part of a mesh.
struct Solid {
  std::vector<uint32_t> primitives;
  const Material* material;
  double extent;  // volume of its box
  Media::Crossing crossing;
  bool holds_camera;

  [[nodiscard]] bool is_sheet() const { return crossing == Media::Crossing::sheet; }
};

double volume(const Box<double>& box) {
  const Vec3d s = box.size();
  return s.x * s.y * s.z;
}

std::vector<Solid> solids_of(const Scene& scene) {
  std::vector<Solid> solids;
  uint32_t next = 0;
  const Vec3d eye = scene.camera.position;
  const auto material_of = [&](const auto& shape) { return &scene.materials[shape.material]; };
  using enum Media::Crossing;
  for (const Plane& p : scene.planes) {
    const uint32_t id = next++;
    if (material_of(p)->k_refract == 0) continue;
    solids.push_back(
        {{id}, material_of(p), std::numeric_limits<double>::infinity(), against, contains(p, eye)});
  }
  for (const Sphere& s : scene.spheres) {
    const uint32_t id = next++;
    if (material_of(s)->k_refract == 0) continue;
    solids.push_back({{id}, material_of(s), 8 * s.radius * s.radius * s.radius, against, contains(s, eye)});
  }
  for (const Mesh& mesh : scene.meshes) {
    const uint32_t first = next;
    next += static_cast<uint32_t>(mesh.triangles.size());
    if (material_of(mesh)->k_refract == 0) continue;
    for (std::vector<uint32_t>& triangles : connected_parts(mesh)) {
      const Mesh part = part_of(mesh, triangles);
      const bool closed = is_closed(part);
      const Media::Crossing crossing = !closed ? sheet : signed_volume(part) < 0 ? along : against;
      for (uint32_t& id : triangles) id += first;
      solids.push_back({std::move(triangles), material_of(mesh), volume(bounds_of(part)), crossing,
                        closed && contains(part, eye)});
    }
  }
  return solids;
}

}  // namespace

Media::Media(const Scene& scene) {
  const size_t count = scene.planes.size() + scene.spheres.size() + scene.triangle_count();
  crossings_.resize(count, Crossing::opaque);
  ranks_.resize(count);
  std::vector<Solid> solids = solids_of(scene);
  // Sheets last: they bound no medium, and their ranks are names only.
  std::ranges::stable_sort(solids, [](const Solid& x, const Solid& y) {
    if (x.is_sheet() != y.is_sheet()) return y.is_sheet();
    if (x.material->priority != y.material->priority) return x.material->priority < y.material->priority;
    return x.extent > y.extent;
  });
  for (uint32_t rank = 0; rank < solids.size(); ++rank) {
    const Solid& solid = solids[rank];
    for (const uint32_t id : solid.primitives) {
      crossings_[id] = solid.crossing;
      ranks_[id] = rank;
    }
    ior_.push_back(solid.material->ior);
    unbounded_.push_back(std::isinf(solid.extent));
    if (solid.holds_camera) at_camera_.enter(rank);
  }
}

}  // namespace raysweep
