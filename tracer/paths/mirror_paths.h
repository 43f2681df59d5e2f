// Paths through scenes in which everything is opaque: from mirror to mirror, one ray at a time.
#pragma once

#include "tracer/settings.h"
#include "tracer/shade/lighting.h"
#include "tracer/shade/radiance_bound.h"

namespace raysweep {

template <class Core>
class MirrorPaths {
 public:
  using T = typename Core::Real;
  struct Scratch {};

  MirrorPaths(const Scene& scene, const RenderSettings& settings)
      : lighting_(scene),
        bound_(scene, settings.depth),
        background_(scene.background),
        depth_(settings.depth),
        tolerance_(settings.pixel_tolerance) {}

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
      if (material.reflect == 0) return sum;
      if (level == depth_) {
        counts.left_out.by_depth++;
        return sum;
      }
      weight *= material.reflect;
      if (tolerance_ > 0 && ends_here(weight, depth_ - level, counts.left_out)) return sum;
      ray = mirrored;
      counts.rays.reflected++;
    }
  }

 private:
  /// The whole rest of the sample is one ray, and a ray with `levels` levels left returns at most their
  /// bound: where that, weighted, is within the tolerance, no channel loses more than the tolerance by
  /// ending. A pixel is the mean of its samples, so it does not either.
  bool ends_here(T weight, int levels, LeftOut& left_out) const {
    const double rest = static_cast<double>(weight) * bound_.at(levels);
    if (!(rest <= tolerance_)) return false;
    left_out.by_tolerance++;
    left_out.bound = std::max(left_out.bound, rest);
    return true;
  }

  Lighting<T> lighting_;
  RadianceBound bound_;
  Vec3<T> background_;
  int depth_;
  double tolerance_;
};

}  // namespace raysweep
