#include "tracer/shade/media.h"

#include <limits>
#include <numeric>

#include "tracer/scene/solid.h"

namespace raysweep {

namespace {

/// A plane, a sphere or a mesh: consecutive primitives with one inside.
struct Solid {
  uint32_t first, count;  // primitives
  const Material* material;
  double extent;  // volume of its box
  Media::Crossing crossing;
  bool holds_camera;
};

double volume(const Box<double>& box) {
  const Vec3d s = box.size();
  return s.x * s.y * s.z;
}

std::vector<Solid> solids_of(const Scene& scene) {
  std::vector<Solid> solids;
  uint32_t next = 0;
  const auto add = [&](uint32_t count, uint32_t material, double extent, Media::Crossing crossing,
                       bool holds_camera) {
    const Material& m = scene.materials[material];
    if (m.k_refract == 0) crossing = Media::Crossing::opaque;
    solids.push_back({next, count, &m, extent, crossing, holds_camera});
    next += count;
  };
  const Vec3d eye = scene.camera.position;
  using enum Media::Crossing;
  for (const Plane& p : scene.planes)
    add(1, p.material, std::numeric_limits<double>::infinity(), against, contains(p, eye));
  for (const Sphere& s : scene.spheres)
    add(1, s.material, 8 * s.radius * s.radius * s.radius, against, contains(s, eye));
  for (const Mesh& mesh : scene.meshes) {
    const auto count = static_cast<uint32_t>(mesh.triangles.size());
    const bool passable = scene.materials[mesh.material].k_refract > 0;
    if (!passable || !is_closed(mesh)) {
      add(count, mesh.material, 0, sheet, false);
    } else {
      add(count, mesh.material, volume(bounds_of(mesh)), signed_volume(mesh) < 0 ? along : against,
          contains(mesh, eye));
    }
  }
  return solids;
}

}  // namespace

Media::Media(const Scene& scene) {
  const std::vector<Solid> solids = solids_of(scene);
  std::vector<uint32_t> bounding;  // solids with a medium inside, lowest rank first
  for (uint32_t i = 0; i < solids.size(); ++i) {
    crossings_.resize(crossings_.size() + solids[i].count, solids[i].crossing);
    if (solids[i].crossing == Crossing::along || solids[i].crossing == Crossing::against)
      bounding.push_back(i);
  }
  std::ranges::stable_sort(bounding, [&](uint32_t a, uint32_t b) {
    const Solid &x = solids[a], &y = solids[b];
    if (x.material->priority != y.material->priority) return x.material->priority < y.material->priority;
    return x.extent > y.extent;
  });
  ranks_.resize(crossings_.size());
  for (uint32_t rank = 0; rank < bounding.size(); ++rank) {
    const Solid& solid = solids[bounding[rank]];
    std::fill_n(ranks_.begin() + solid.first, solid.count, rank);
    ior_.push_back(solid.material->ior);
    unbounded_.push_back(std::isinf(solid.extent));
    if (solid.holds_camera) at_camera_.enter(rank);
  }
  auto next = static_cast<uint32_t>(bounding.size());
  for (const Solid& solid : solids) {
    if (solid.crossing == Crossing::sheet) std::fill_n(ranks_.begin() + solid.first, solid.count, next++);
  }
}

}  // namespace raysweep
