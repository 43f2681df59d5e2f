#include <algorithm>
#include <cmath>
#include <numbers>

#include "tracer/sample/point_sets.h"

namespace raysweep {

std::vector<Subpixel> make_circle(int count, double radius, double phase) {
  constexpr double below_one = 1 - 0x1p-24;  // in float too: a circle of radius 0.5 touches the next pixel
  std::vector<Subpixel> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * (i + phase) / count;
    points.push_back({std::min(0.5 + radius * std::cos(angle), below_one),
                      std::min(0.5 + radius * std::sin(angle), below_one)});
  }
  return points;
}

}  // namespace raysweep
