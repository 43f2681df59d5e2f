// A whole picture made again and again on one thread, and how far it is from another.
#pragma once

#include <memory>
#include <vector>

#include "results/pixels_record.h"
#include "tracer/flip.h"
#include "tracer/render.h"

namespace raysweep {

class PixelsMaker {
 public:
  /// Builds geometry and hierarchy, and makes the picture once, which warms up. Throws as `make_renderer`.
  PixelsMaker(const Scene& scene, const RenderSettings& settings);

  /// Makes the picture; the seconds that it took.
  double frame();

  [[nodiscard]] const Film& film() const { return film_; }
  /// Rays of one frame, of all kinds.
  [[nodiscard]] uint64_t ray_count() const { return ray_count_; }
  /// What the ray through each pixel's centre meets first, in row order.
  [[nodiscard]] std::vector<uint32_t> hit_ids() const;

 private:
  std::unique_ptr<const Renderer> renderer_;
  std::unique_ptr<Workspace> workspace_;
  Film film_;
  uint64_t ray_count_ = 0;
};

/// Sets what `record` says of the picture: its size, its rays, and how far it is from the reference,
/// everywhere and at edges.
void tell_errors(PixelsRecord& record, const PixelsMaker& maker, const PixelsMaker& reference,
                 const FlipMap& map);

}  // namespace raysweep
