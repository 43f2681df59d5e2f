#include "results/statistics/stopping.h"

#include <algorithm>

namespace raysweep {

int next_look(int launches_so_far, int first, int cap) {
  int look = std::max(first, 1);
  while (look <= launches_so_far && look < cap) look *= 2;
  return std::min(look, cap);
}

bool converged(const Estimate& estimate, double relative_half_width) {
  const auto width = estimate.relative_half_width();
  return width && *width <= relative_half_width;
}

}  // namespace raysweep
