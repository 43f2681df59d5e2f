#include "results/claims/rules.h"

#include <algorithm>
#include <cmath>

namespace raysweep {

namespace {

/// Counts of failures may be 0 on both sides: then neither is larger.
double quotient(double a, double b) { return a == b ? 1 : a / b; }

}  // namespace

double largest_against(const std::vector<double>& expected, const std::vector<double>& others) {
  return quotient(*std::ranges::max_element(expected), *std::ranges::max_element(others));
}

double smallest_against(const std::vector<double>& expected, const std::vector<double>& others) {
  return quotient(*std::ranges::min_element(others), *std::ranges::min_element(expected));
}

double spread(const std::vector<double>& values) {
  const auto [low, high] = std::ranges::minmax_element(values);
  return quotient(*high, *low);
}

double least_neighbour_ratio(const std::vector<double>& values, bool smallest_first) {
  double least = INFINITY;
  for (size_t i = 1; i < values.size(); ++i) {
    const double ratio =
        smallest_first ? quotient(values[i], values[i - 1]) : quotient(values[i - 1], values[i]);
    least = std::min(least, ratio);
  }
  return least;
}

double largest_residual(const std::vector<double>& x, const std::vector<double>& y, bool intercept) {
  const double n = static_cast<double>(x.size());
  double mean_x = 0, mean_y = 0;
  for (size_t i = 0; intercept && i < x.size(); ++i) mean_x += x[i] / n, mean_y += y[i] / n;
  double xx = 0, xy = 0;
  for (size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
  }
  double largest = 0;
  for (size_t i = 0; i < x.size(); ++i) {
    const double fit = mean_y + xy / xx * (x[i] - mean_x);
    largest = std::max(largest, std::abs(fit - y[i]) / std::abs(y[i]));
  }
  return largest;
}

}  // namespace raysweep
