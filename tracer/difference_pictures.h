// Differences of pictures, as pictures.
#pragma once

#include "tracer/film.h"
#include "tracer/flip.h"

namespace raysweep {

/// Linear RGB that stands for `share`, 0 to 1: black over violet, red and orange to white, the lightness of
/// what is shown growing evenly. A cubehelix (Green 2011, "A colour scheme for the display of astronomical
/// intensity images") that turns by a third, in the colours of the map magma that ꟻLIP's authors use.
[[nodiscard]] Vec3f colour_of_share(double share);

/// The map in these colours.
[[nodiscard]] Film picture_of(const FlipMap& map);

/// The reference in dark grey, and in it, by their ꟻLIP, those pixels of `picture` that are wrong by
/// `is_wrong`. All three must be of one size.
[[nodiscard]] Film wrong_pixels_picture(const Film& picture, const Film& reference, const FlipMap& map);

}  // namespace raysweep
