// The mean of the middle samples: moved by none of the odd ones.
#pragma once

#include <vector>

namespace raysweep {

struct TrimmedMean {
  double mean = 0;
  double variance = 0;  // of the mean, from the winsorised samples
  int kept = 0;         // samples between the trimmed ends
};

inline constexpr double trimmed_share =
    0.2;  // at each end: Wilcox 2012, "Introduction to Robust Estimation", 3.3

/// The fifth of the samples at each end left out, rounded down: Tukey & McLaughlin 1963. Needs two samples
/// that are left; with fewer the variance is 0.
[[nodiscard]] TrimmedMean trimmed_mean(std::vector<double> samples);

}  // namespace raysweep
