// Embree as a core of staged renderers: it finds the triangles, planes and spheres are found by our own code.
#pragma once

#include <memory>
#include <optional>

#include "tracer/peers/embree_scene.h"
#include "tracer/peers/embree_shapes.h"
#include "tracer/wide/kernels.h"

namespace raysweep {

/// How rays of one kind are handed to Embree.
struct EmbreePackets {
  unsigned width = 16;   // 1, 4, 8 or 16
  bool coherent = true;  // what Embree is told of them
};

struct EmbreeModes {
  EmbreePackets primary, shadow, mirrored;
};

/// A scene in Embree's hands and in ours, and how rays are traced through both; renderers may share both.
struct EmbreeGeometry {
  std::shared_ptr<const EmbreeShapes> shapes;
  std::shared_ptr<const EmbreeScene> triangles;
  EmbreeModes modes;
  double (*now)() = nullptr;  // in seconds: read before and after each batch
};

/// One worker's memory and what its rays took.
struct EmbreeScratch {
  void begin_level(int level) { is_primary = level == 1; }

  KernelScratch memory;
  LaneArray<int> active;  // Embree's masks: −1 or 0
  bool is_primary = true;
  double seconds_inside = 0;  // in Embree's calls, laying out rays and reading hits apart
};

class EmbreeCore {
 public:
  /// Hierarchy and leaves are Embree's own.
  EmbreeCore(const Scene&, const std::string&, int, const EmbreeGeometry& geometry) : geometry_(geometry) {}

  [[nodiscard]] const EmbreeShapes& primitives() const { return *geometry_.shapes; }
  [[nodiscard]] std::optional<Hit<float>> closest(const Ray<float>& ray) const;
  /// As WideCore's, but of rays with something in their way the hit itself is not told: the first triangle's
  /// id stands for all, at the ray's limit. A ray that Embree does not take meets no triangle.
  void closest(const RayBatch& rays, HitBatch& hits, EmbreeScratch& scratch) const;
  void occluded(const RayBatch& rays, HitBatch& hits, EmbreeScratch& scratch) const;

 private:
  EmbreeGeometry geometry_;
};

}  // namespace raysweep
