// Where inside a pixel its samples lie.
#pragma once

#include <string>
#include <vector>

namespace raysweep {

/// An offset from a pixel's upper left corner, in pixels: 0 ≤ x, y < 1.
struct Subpixel {
  double x, y;
};

/// `count` ≥ 1 subpixels of `pattern`, which is one of
///
///     grid  rotated_grid  circle  circle:RADIUS  circle:RADIUS:PHASE  halton  sobol  sobol:SEED
///
/// with 0 < RADIUS ≤ 0.5 in pixels, 0 ≤ PHASE < 1 in steps between points, and SEED a whole number below 2³².
/// Their mean is the box filter's. One subpixel is the pixel's centre in every pattern. All pixels use the
/// same points, so that a colour stays a function of scene, settings and pixel.
/// Throws std::invalid_argument with `pattern_problem`'s sentence, or for a count below 1.
[[nodiscard]] std::vector<Subpixel> make_pattern(const std::string& pattern, int count);

/// Empty if `make_pattern` takes `pattern`, otherwise a sentence on what is wrong and what is possible.
[[nodiscard]] std::string pattern_problem(const std::string& pattern);

}  // namespace raysweep
