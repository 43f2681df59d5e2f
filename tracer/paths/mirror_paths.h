// Paths through scenes in which everything is opaque: from mirror to mirror, one ray at a time.
#pragma once

#include "tracer/paths/path_end.h"
#include "tracer/shade/lighting.h"

namespace raysweep {

template <class Core>
class MirrorPaths {
 public:
  using T = typename Core::Real;
  struct Scratch {};

  MirrorPaths(const Scene& scene, const RenderSettings& settings)
      : lighting_(scene), end_(scene, settings), background_(scene.background) {}

  /// What `ray` brings back. A loop, not a recursion: any depth fits on any worker's stack.
  Vec3<T> trace(const Core& core, Ray<T> ray, RenderCounts& counts, Scratch&) const {
    Vec3<T> sum;
    T weight = 1;
    for (int level = 1;; ++level) {
      const auto hit = core.closest(ray);
      if (!hit) return sum + background_ * weight;
      const Surface<T> surface = core.primitives().surface(ray, *hit);
      const Surfacing<T>& material = lighting_.material(core.primitives().material(hit->id));
      const Ray<T> mirrored =
          spawn(surface, normalize(reflect(ray.direction, surface.normal)), true, surface.clearance);
      const auto visible = [&core](const Ray<T>& to_light, T distance) {
        return !core.occluded(to_light, distance);
      };
      sum += weight *
             lighting_.at(material, mirrored.origin, surface.normal, ray.direction, counts.rays, visible);
      if (end_.is_here(material, level, weight, counts.left_out)) return sum;
      ray = mirrored;
      counts.rays.reflected++;
    }
  }

 private:
  Lighting<T> lighting_;
  PathEnd<T> end_;
  Vec3<T> background_;
};

}  // namespace raysweep
