// Where a path from mirror to mirror ends.
#pragma once

#include "tracer/render_counts.h"
#include "tracer/settings.h"
#include "tracer/shade/phong.h"
#include "tracer/shade/radiance_bound.h"

namespace raysweep {

template <class T>
class PathEnd {
 public:
  PathEnd(const Scene& scene, const RenderSettings& settings)
      : bound_(scene, settings.depth), depth_(settings.depth), tolerance_(settings.pixel_tolerance) {}

  /// Whether a path of `weight` ends at a surface of `material`, its `level`th; else `weight` becomes that of
  /// what the surface reflects.
  [[nodiscard]] bool is_here(const Surfacing<T>& material, int level, T& weight, LeftOut& left_out) const {
    if (material.reflect == 0) return true;
    if (level == depth_) {
      left_out.by_depth++;
      return true;
    }
    weight *= material.reflect;
    return tolerance_ > 0 && is_within_tolerance(weight, depth_ - level, left_out);
  }

 private:
  /// The whole rest of the sample is one ray, and a ray with `levels` levels left returns at most their
  /// bound: where that, weighted, is within the tolerance, no channel loses more than the tolerance by
  /// ending. A pixel is the mean of its samples, so it does not either.
  bool is_within_tolerance(T weight, int levels, LeftOut& left_out) const {
    const double rest = static_cast<double>(weight) * bound_.at(levels);
    if (!(rest <= tolerance_)) return false;
    left_out.by_tolerance++;
    left_out.bound = std::max(left_out.bound, rest);
    return true;
  }

  RadianceBound bound_;
  int depth_;
  double tolerance_;
};

}  // namespace raysweep
