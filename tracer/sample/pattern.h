// Where inside a pixel its samples lie.
#pragma once

#include <string>
#include <vector>

namespace raysweep {

/// An offset from a pixel's upper left corner, in pixels: 0 ≤ x, y < 1.
struct Subpixel {
  double x, y;
};

/// `count` ≥ 1 subpixels of the pattern named `pattern`; one subpixel is the pixel's centre in every pattern.
/// Throws std::invalid_argument for an unknown name.
[[nodiscard]] std::vector<Subpixel> make_pattern(const std::string& pattern, int count);

}  // namespace raysweep
