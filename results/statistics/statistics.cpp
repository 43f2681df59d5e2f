#include "results/statistics/statistics.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <cstddef>

namespace raysweep {

std::optional<double> Estimate::relative_half_width() const {
  if (!interval || value == 0) return std::nullopt;
  return (interval->high - interval->low) / 2 / std::abs(value);
}

double median(std::vector<double> samples) {
  std::ranges::sort(samples);
  const size_t half = samples.size() / 2;
  return samples.size() % 2 == 1 ? samples[half] : (samples[half - 1] + samples[half]) / 2;
}

double quantile(std::vector<double> samples, double share) {
  const double position = share * (static_cast<double>(samples.size()) - 1);
  const auto below = static_cast<std::ptrdiff_t>(position);
  const auto at = samples.begin() + below;
  std::nth_element(samples.begin(), at, samples.end());
  const double part = position - static_cast<double>(below);
  if (part == 0) return *at;
  const double next = *std::min_element(at + 1, samples.end());
  return *at + part * (next - *at);
}

std::optional<int> median_interval_rank(int n) {
  const boost::math::binomial_distribution<> below_median(n, 0.5);
  std::optional<int> rank;
  for (int k = 0; 2 * k < n && 1 - 2 * cdf(below_median, k) >= 0.95; ++k) rank = k;
  return rank;
}

std::optional<int> upper_bound_rank(int n, double share) {
  const boost::math::binomial_distribution<> above(n, 1 - share);
  std::optional<int> rank;
  for (int k = 0; k < n && cdf(above, k) <= 0.05; ++k) rank = k;
  return rank;
}

Estimate estimate_median(std::vector<double> samples) {
  Estimate estimate;
  estimate.value = median(samples);
  estimate.count = static_cast<int>(samples.size());
  if (const auto rank = median_interval_rank(estimate.count)) {
    std::ranges::sort(samples);
    const auto k = static_cast<size_t>(*rank);
    estimate.interval = {samples[k], samples[samples.size() - 1 - k]};
  }
  return estimate;
}

}  // namespace raysweep
