#pragma once
#include <vector>
namespace raysweep {
[[nodiscard]] int next_look(int launches_so_far, int first, int cap);
[[nodiscard]] bool converged(const std::vector<double>& samples, double target);
}  // namespace raysweep
