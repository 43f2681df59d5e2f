#include "results/statistics/trimmed_mean.h"

#include <algorithm>

namespace raysweep {

TrimmedMean trimmed_mean(std::vector<double> samples) {
  std::ranges::sort(samples);
  const size_t n = samples.size();
  const auto trimmed = static_cast<size_t>(trimmed_share * static_cast<double>(n));
  TrimmedMean result;
  result.kept = static_cast<int>(n - 2 * trimmed);
  for (size_t i = trimmed; i < n - trimmed; ++i) result.mean += samples[i];
  result.mean /= result.kept;
  if (result.kept < 2) return result;

  double sum = 0, squares = 0;  // of the winsorised samples, from the trimmed mean on
  for (const double sample : samples) {
    const double winsorised = std::clamp(sample, samples[trimmed], samples[n - 1 - trimmed]) - result.mean;
    sum += winsorised;
    squares += winsorised * winsorised;
  }
  squares -= sum * sum / static_cast<double>(n);
  result.variance = std::max(squares, 0.0) / result.kept / (result.kept - 1);
  return result;
}

}  // namespace raysweep
