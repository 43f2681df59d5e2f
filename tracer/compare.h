// How far a picture is from a reference.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "tracer/film.h"

namespace raysweep {

/// Of 255: what any difference, however small, may become by rounding to 8 bit.
inline constexpr int tolerated_8bit = 1;

struct PictureDifference {
  /// Means over the linear channels of the pixels that are finite in both pictures; NaN if there are none.
  /// The relative one is of (a − b)² / (b² + 0.01), b the reference (Rousselle, Knaus & Zwicker 2011, with
  /// the constant that was common later): it weighs dark and bright regions alike, 0.01 keeps black finite.
  double rmse = 0, relative_mse = 0;
  /// Over all pixels as an 8-bit sRGB file shows them, where NaN is 0 and infinity 255: the largest
  /// difference of a channel, and the pixels that are not equal.
  int max_8bit = 0;
  size_t differing_pixels = 0;
  /// Those among them that differ by more than `tolerated_8bit` in a channel.
  size_t wrong_pixels = 0;
  /// Pixels with a channel that is infinite or NaN in one picture or in both, equal or not.
  size_t non_finite = 0;
  /// Pixels whose centre sees another primitive, if both pictures know what theirs see.
  size_t differing_hits = 0;
  /// Those among them that see nothing where the reference sees something.
  size_t holes = 0;
  bool hits_known = false;
};

/// The largest difference of a channel in 8-bit sRGB, as a PNG file shows both.
[[nodiscard]] int byte_difference(const Vec3f& a, const Vec3f& b);
/// Whether a pixel of these colours counts among the wrong ones.
[[nodiscard]] inline bool is_wrong(const Vec3f& a, const Vec3f& b) {
  return byte_difference(a, b) > tolerated_8bit;
}

/// Throws std::invalid_argument when the pictures' sizes differ.
void refuse_different_sizes(const Film& picture, const Film& reference);

/// The ids are width·height hit ids in row order, or none if unknown. Throws std::invalid_argument when the
/// pictures' sizes differ, or the ids are as many as neither.
[[nodiscard]] PictureDifference compare(const Film& picture, std::span<const uint32_t> ids,
                                        const Film& reference, std::span<const uint32_t> reference_ids);

}  // namespace raysweep
