// The constructions behind the patterns: `count` ≥ 2 different points of the pixel each.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "tracer/sample/pattern.h"

namespace raysweep {

/// Equal cells in rows.
[[nodiscard]] std::vector<Subpixel> make_grid(int count);

/// A lattice whose x are all different and evenly spaced, and its y too. O(count · log count).
[[nodiscard]] std::vector<Subpixel> make_rotated_grid(int count);

/// Radius 1/√6: the circle then has the pixel's own second moment (r²/2 = 1/12 an axis), so both blur alike.
/// The first point stands a fifth of a step past the x axis: four points then make the rotated grid, whose x
/// and y are all different and evenly spaced, and no other small count aligns points with rows or columns.
inline const double default_circle_radius = 1 / std::sqrt(6.0), default_circle_phase = 0.2;

/// Points evenly on a circle around the centre, `radius` in pixels. The first stands `phase` steps between
/// points past the x axis, towards y.
[[nodiscard]] std::vector<Subpixel> make_circle(int count, double radius, double phase);

/// The Halton sequence in the bases 2 and 3.
[[nodiscard]] std::vector<Subpixel> make_halton(int count);

/// The first two dimensions of the Sobol sequence, Owen-scrambled; equal seeds give equal points.
[[nodiscard]] std::vector<Subpixel> make_sobol(int count, uint32_t seed);

}  // namespace raysweep
