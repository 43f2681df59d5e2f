#include "tracer/compare.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace raysweep {

namespace {

void check_sizes(const Film& picture, std::span<const uint32_t> ids, const Film& reference,
                 std::span<const uint32_t> reference_ids) {
  refuse_different_sizes(picture, reference);
  for (const auto& of_one : {ids, reference_ids}) {
    if (!of_one.empty() && of_one.size() != picture.pixels().size()) {
      throw std::invalid_argument(fmt::format("{} hit ids do not belong to a picture of {} × {} pixels",
                                              of_one.size(), picture.width(), picture.height()));
    }
  }
}

}  // namespace

int byte_difference(const Vec3f& a, const Vec3f& b) {
  int largest = 0;
  for (int channel = 0; channel < 3; ++channel)
    largest = std::max(largest, std::abs(to_srgb_byte(a[channel]) - to_srgb_byte(b[channel])));
  return largest;
}

void refuse_different_sizes(const Film& picture, const Film& reference) {
  if (picture.width() == reference.width() && picture.height() == reference.height()) return;
  throw std::invalid_argument(
      fmt::format("pictures of different size cannot be compared: {} × {} pixels, the reference {} × {}",
                  picture.width(), picture.height(), reference.width(), reference.height()));
}

PictureDifference compare(const Film& picture, std::span<const uint32_t> ids, const Film& reference,
                          std::span<const uint32_t> reference_ids) {
  check_sizes(picture, ids, reference, reference_ids);
  PictureDifference difference;
  double squares = 0, relative_squares = 0;
  for (size_t i = 0; i < picture.pixels().size(); ++i) {
    const Vec3f &a = picture.pixels()[i], &b = reference.pixels()[i];
    const int bytes = byte_difference(a, b);
    difference.max_8bit = std::max(difference.max_8bit, bytes);
    difference.differing_pixels += bytes > 0;
    difference.wrong_pixels += bytes > tolerated_8bit;
    if (!all_finite(a) || !all_finite(b)) {
      difference.non_finite++;
      continue;
    }
    for (int channel = 0; channel < 3; ++channel) {
      const double expected = b[channel], error = a[channel] - expected;
      squares += error * error;
      relative_squares += error * error / (expected * expected + 0.01);
    }
  }
  const auto count = 3 * static_cast<double>(picture.pixels().size() - difference.non_finite);
  difference.rmse = std::sqrt(squares / count);
  difference.relative_mse = relative_squares / count;
  difference.hits_known = !ids.empty() && !reference_ids.empty();
  if (difference.hits_known) {
    for (size_t i = 0; i < ids.size(); ++i) {
      difference.differing_hits += ids[i] != reference_ids[i];
      difference.holes += ids[i] == no_hit_id && reference_ids[i] != no_hit_id;
    }
  }
  return difference;
}

}  // namespace raysweep
