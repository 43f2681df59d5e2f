// Medians and their intervals: pure functions of samples.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace raysweep {

/// A value with a confidence interval around it, where one can be had.
struct Estimate {
  double value = 0;
  struct Bounds {
    double low, high;
  };
  std::optional<Bounds> interval;  // 95 %
  int count = 0;                   // samples

  /// Half the interval's width relative to the value; none without an interval.
  [[nodiscard]] std::optional<double> relative_half_width() const;
};

/// The middle of `samples` (mean of the middle two for an even count). Not for an empty list.
[[nodiscard]] double median(std::vector<double> samples);

/// What the share `share`, 0 to 1, of the samples is below, between neighbours by a straight line: definition
/// 7 of Hyndman & Fan 1996, the default of R and NumPy. Not for an empty list.
[[nodiscard]] double quantile(std::vector<double> samples, double share);

/// What no failure in `count` tries lets expect at most, as a share, at 95 %: 3/n ("rule of three", Hanley &
/// Lippman-Hand 1983).
[[nodiscard]] constexpr double zero_failures_bound(size_t count) {
  return count == 0 ? 1 : 3 / static_cast<double>(count);
}

/// How many order statistics to leave out on each side: the largest k for which [x(k+1), x(n−k)] covers the
/// median with at least 95 %, whatever the distribution: coverage is 1 − 2·P(B ≤ k), B binomial(n, ½). None
/// for n < 6, where even the whole range covers it less often (David & Nagaraja 2003, "Order
/// Statistics", 7.1).
[[nodiscard]] std::optional<int> median_interval_rank(int n);

/// How many of the largest of `n` samples to leave out so that the next one is, at 95 %, not below what the
/// share `share` of all there are stays below, whatever the distribution: the largest k with P(B ≤ k) ≤ 0.05,
/// B binomial(n, 1 − share). None where n is too small for that (Wilks 1941, "Determination of sample sizes
/// for setting tolerance limits").
[[nodiscard]] std::optional<int> upper_bound_rank(int n, double share);

/// The median of `samples` with its 95 % order-statistic interval. Not for an empty list.
[[nodiscard]] Estimate estimate_median(std::vector<double> samples);

}  // namespace raysweep
