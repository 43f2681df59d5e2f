// Where a picture has edges, and how far another is from it there.
#pragma once

#include <cstdint>
#include <vector>

#include "tracer/film.h"

namespace raysweep {

/// Whether a pixel, in row order, differs from one beside, above or below it by more than 32 of 255 in a
/// channel as a PNG file shows them: shading that changes over some ten pixels stays below that.
[[nodiscard]] std::vector<bool> edge_pixels(const Film& picture);

struct EdgeError {
  uint64_t pixels = 0;
  double rmse = 0;  // of linear channels of those that are finite in both; NaN without any
};

/// Over the edges of the reference. Throws std::invalid_argument when the pictures' sizes differ.
[[nodiscard]] EdgeError error_at_edges(const Film& picture, const Film& reference);

}  // namespace raysweep
