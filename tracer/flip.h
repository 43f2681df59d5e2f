// ꟻLIP for pictures as a display shows them: how much of a difference a person sees who flips between the
// two.
#pragma once

#include <numbers>
#include <span>
#include <vector>

#include "tracer/film.h"

namespace raysweep {

/// Of the paper's viewer: 0.7 m before a screen that is 0.7 m wide and has 3840 pixels in a row; 67.02.
inline constexpr double paper_pixels_per_degree = 3840 * std::numbers::pi / 180;

/// The difference at each pixel, 0 (none) to 1 (as green and blue), in row order.
class FlipMap {
 public:
  FlipMap(int width, int height, std::vector<float> values)
      : width_(width), height_(height), values_(std::move(values)) {}

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] std::span<const float> values() const& { return values_; }
  std::span<const float> values() && = delete;  // they would not outlive their map

  [[nodiscard]] double mean() const;
  [[nodiscard]] double max() const;
  /// What the share `share`, 0 to 1, of the pixels is below, between neighbours by a straight line.
  [[nodiscard]] double quantile(double share) const;

 private:
  int width_, height_;
  std::vector<float> values_;
};

/// LDR-ꟻLIP of Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström & Fairchild 2020, "ꟻLIP: A Difference
/// Evaluator for Alternating Images". Colours are clamped to 0…1, NaN to 0, but not rounded to 8 bit; beyond
/// its edges a picture goes on as it ends. Symmetric. Throws std::invalid_argument where sizes differ.
[[nodiscard]] FlipMap flip(const Film& picture, const Film& reference,
                           double pixels_per_degree = paper_pixels_per_degree);

}  // namespace raysweep
