#include <cmath>

#include "tracer/sample/point_sets.h"

namespace raysweep {

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

}  // namespace raysweep
