// Whole pictures by one renderer and a few threads that share its tiles, in the same way for every tracer.
#pragma once

#include "tracer/render.h"

namespace raysweep {

/// The side of a tile. Of one sample a pixel and few lights, a tile's samples make one batch of the staged
/// renderers.
inline constexpr int picture_tile = 32;

class PictureMaker {
 public:
  PictureMaker(std::unique_ptr<const Renderer> renderer, int width, int height, int threads);

  /// Renders every `stride`th tile, beginning with the first; the seconds that it took.
  double run(size_t stride = 1);

  [[nodiscard]] size_t tile_count() const;
  [[nodiscard]] const Film& film() const { return film_; }
  /// One for each thread.
  [[nodiscard]] const std::vector<std::unique_ptr<Workspace>>& workspaces() const { return workspaces_; }

 private:
  [[nodiscard]] Tile tile(size_t index) const;

  std::unique_ptr<const Renderer> renderer_;
  Film film_;
  std::vector<std::unique_ptr<Workspace>> workspaces_;
};

struct PixelDifferences {
  size_t pixels = 0;
  double largest = 0;  // of any channel, in film units; infinite where one film alone has no number
};

/// Of two films of the same size, bit for bit.
[[nodiscard]] PixelDifferences pixel_differences(const Film& a, const Film& b);

}  // namespace raysweep
