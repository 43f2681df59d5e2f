// Filters of pictures that are a product of one along rows and one along columns.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace raysweep {

/// One number a pixel, in row order.
struct ImagePlane {
  int width, height;
  std::vector<double> values;

  ImagePlane(int w, int h) : width(w), height(h), values(static_cast<size_t>(w) * static_cast<size_t>(h)) {}
  [[nodiscard]] const double* row(int y) const {
    return values.data() + static_cast<size_t>(y) * static_cast<size_t>(width);
  }
  [[nodiscard]] double* row(int y) {
    return values.data() + static_cast<size_t>(y) * static_cast<size_t>(width);
  }
};

/// Weights from −radius to radius, an odd number of them.
using FilterWeights = std::vector<double>;

template <class Weight>
[[nodiscard]] FilterWeights kernel_of(int radius, const Weight& weight) {
  FilterWeights kernel;
  for (int x = -radius; x <= radius; ++x) kernel.push_back(weight(static_cast<double>(x)));
  return kernel;
}

[[nodiscard]] inline FilterWeights sum_to_one(FilterWeights kernel) {
  const double sum = std::accumulate(kernel.begin(), kernel.end(), 0.0);
  for (double& weight : kernel) weight /= sum;
  return kernel;
}

/// Positive weights sum to 1, negative ones to −1; there must be some of both.
[[nodiscard]] inline FilterWeights signs_to_one(FilterWeights kernel) {
  double above = 0, below = 0;
  for (const double weight : kernel) (weight > 0 ? above : below) += weight;
  for (double& weight : kernel) weight /= weight > 0 ? above : -below;
  return kernel;
}

/// `plane`, correlated with `across` along rows and `down` along columns; beyond its edges it goes on as it
/// ends.
[[nodiscard]] inline ImagePlane filtered(const ImagePlane& plane, const FilterWeights& across,
                                         const FilterWeights& down) {
  const auto radius_of = [](const FilterWeights& kernel) { return static_cast<int>(kernel.size() / 2); };
  ImagePlane rows(plane.width, plane.height), result(plane.width, plane.height);
  std::vector<double> padded(static_cast<size_t>(plane.width) + across.size() - 1);
  for (int y = 0; y < plane.height; ++y) {
    const double* const row = plane.row(y);
    for (int x = 0; x < static_cast<int>(padded.size()); ++x)
      padded[static_cast<size_t>(x)] = row[std::clamp(x - radius_of(across), 0, plane.width - 1)];
    for (size_t i = 0; i < across.size(); ++i) {
      for (int x = 0; x < plane.width; ++x) rows.row(y)[x] += across[i] * padded[static_cast<size_t>(x) + i];
    }
  }
  for (int y = 0; y < plane.height; ++y) {
    for (size_t i = 0; i < down.size(); ++i) {
      const int from = std::clamp(y + static_cast<int>(i) - radius_of(down), 0, plane.height - 1);
      for (int x = 0; x < plane.width; ++x) result.row(y)[x] += down[i] * rows.row(from)[x];
    }
  }
  return result;
}

}  // namespace raysweep
