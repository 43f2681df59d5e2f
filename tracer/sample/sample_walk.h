// The order in which a tile's samples are taken.
#pragma once

#include <algorithm>
#include <cstddef>

#include "tracer/render.h"

namespace raysweep {

/// Goes through all samples of a tile, pixel by pixel, in squares of 4 × 4 pixels as far as the tile has
/// them: neighbours, whose rays go the same way, follow one another on both axes.
class SampleWalk {
 public:
  int x, y;  // pixel
  size_t subpixel = 0;

  SampleWalk(const Tile& tile, size_t subpixels)
      : x(tile.x),
        y(tile.y),
        left_(tile.x),
        right_(tile.x + tile.width),
        bottom_(tile.y + tile.height),
        square_x_(tile.x),
        square_y_(tile.y),
        subpixels_(subpixels) {}

  /// Whether the next sample is another pixel's.
  bool next() {
    if (++subpixel < subpixels_) return false;
    subpixel = 0;
    if (++x < std::min(square_x_ + side, right_)) return true;
    x = square_x_;
    if (++y < std::min(square_y_ + side, bottom_)) return true;
    square_x_ += side;
    if (square_x_ >= right_) {
      square_x_ = left_;
      square_y_ += side;
    }
    x = square_x_;
    y = square_y_;
    return true;
  }

 private:
  static constexpr int side = 4;

  int left_, right_, bottom_, square_x_, square_y_;
  size_t subpixels_;
};

}  // namespace raysweep
