#include "experiments/picture_edges.h"

#include <cmath>

#include "tracer/compare.h"

namespace raysweep {

namespace {

constexpr int greatest_shading = 32;  // of 255

}  // namespace

std::vector<bool> edge_pixels(const Film& picture) {
  const auto width = static_cast<size_t>(picture.width());
  const auto pixels = picture.pixels();
  std::vector<bool> is_edge(pixels.size());
  const auto compare_with = [&](size_t i, size_t neighbour) {
    if (byte_difference(pixels[i], pixels[neighbour]) <= greatest_shading) return;
    is_edge[i] = true;
    is_edge[neighbour] = true;
  };
  for (size_t i = 0; i < pixels.size(); ++i) {
    if ((i + 1) % width != 0) compare_with(i, i + 1);
    if (i + width < pixels.size()) compare_with(i, i + width);
  }
  return is_edge;
}

EdgeError error_at_edges(const Film& picture, const Film& reference) {
  refuse_different_sizes(picture, reference);
  const std::vector<bool> is_edge = edge_pixels(reference);
  EdgeError error;
  double squares = 0, channels = 0;
  for (size_t i = 0; i < is_edge.size(); ++i) {
    if (!is_edge[i]) continue;
    error.pixels++;
    const Vec3f &a = picture.pixels()[i], &b = reference.pixels()[i];
    if (!all_finite(a) || !all_finite(b)) continue;
    for (int channel = 0; channel < 3; ++channel) {
      const double difference = static_cast<double>(a[channel]) - b[channel];
      squares += difference * difference;
      channels++;
    }
  }
  error.rmse = std::sqrt(squares / channels);
  return error;
}

}  // namespace raysweep
