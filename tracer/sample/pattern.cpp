#include "tracer/sample/pattern.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace raysweep {

namespace {

/// round(√count) rows; row i holds ⌊(i+1)·count/rows⌋ − ⌊i·count/rows⌋ cells and is as high as its share of
/// the cells, so every cell has the same area and the mean over their centres is the box filter's.
std::vector<Subpixel> make_grid(int count) {
  std::vector<Subpixel> points;
  const int rows = static_cast<int>(std::lround(std::sqrt(count)));
  for (int row = 0; row < rows; ++row) {
    const auto before = static_cast<int>(static_cast<long long>(row) * count / rows);
    const auto until = static_cast<int>(static_cast<long long>(row + 1) * count / rows);
    const double y = 0.5 * (before + until) / count;
    for (int i = before; i < until; ++i) points.push_back({(i - before + 0.5) / (until - before), y});
  }
  return points;
}

/// Radius 1/√6: the circle then has the pixel's own second moment (r²/2 = 1/12 an axis), so both blur alike.
/// The first point stands a fifth of a step past the x axis: four points then make the rotated grid, whose x
/// and y are all different and evenly spaced, and no other small count aligns points with rows or columns.
std::vector<Subpixel> make_circle(int count) {
  if (count == 1) return {{0.5, 0.5}};
  const double radius = 1 / std::sqrt(6.0);
  std::vector<Subpixel> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.2) / count;
    points.push_back({0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle)});
  }
  return points;
}

}  // namespace

std::vector<Subpixel> make_pattern(const std::string& pattern, int count) {
  if (pattern == "grid") return make_grid(count);
  if (pattern == "circle") return make_circle(count);
  throw std::invalid_argument("unknown pattern \"" + pattern + "\"");
}

}  // namespace raysweep
