#include "results/stopping.h"

#include <algorithm>

#include "results/statistics.h"
namespace raysweep {
int next_look(int launches_so_far, int first, int cap) {
  if (launches_so_far < first) return first;
  return std::min(2 * launches_so_far, cap);
}
bool converged(const std::vector<double>& samples, double target) {
  const auto width = estimate_median(samples).relative_half_width();
  return width && *width <= target;
}
}  // namespace raysweep
