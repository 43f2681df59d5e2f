#include "results/statistics.h"

#include <algorithm>
#include <cmath>

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

std::optional<int> median_interval_rank(int n) {
  double below = 0;  // P(B ≤ k)
  std::optional<int> rank;
  for (int k = 0; 2 * k < n; ++k) {
    // P(B = k) in logarithms: 2⁻ⁿ itself underflows from n = 1075 on.
    below +=
        std::exp(std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0) - n * std::log(2.0));
    if (1 - 2 * below < 0.95) break;
    rank = k;
  }
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
