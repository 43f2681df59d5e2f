#include "tracer/difference_pictures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tracer/compare.h"
#include "tracer/display_colour.h"

namespace raysweep {

namespace {

/// The inverse of what PNG files are written by (IEC 61966-2-1).
double linear_of_srgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

}  // namespace

Vec3f colour_of_share(double share) {
  // Green's angle in turns, start/3 + rotations·share: from violet past red to yellow; and his hue, the width
  // of the helix: no channel is cut off anywhere, as one is at 1.8.
  constexpr double first_turn = 1.0 / 12, turns = 1.0 / 3, hue = 1.5;
  const double angle = 2 * std::numbers::pi * (first_turn + turns * share);
  const double radius = hue * share * (1 - share) / 2, cosine = std::cos(angle), sine = std::sin(angle);
  const auto channel = [&](double of_cosine, double of_sine) {
    const double encoded = share + radius * (of_cosine * cosine + of_sine * sine);
    return static_cast<float>(linear_of_srgb(std::clamp(encoded, 0.0, 1.0)));
  };
  return {channel(-0.14861, 1.78277), channel(-0.29227, -0.90649), channel(1.97294, 0)};
}

Film picture_of(const FlipMap& map) {
  Film film(map.width(), map.height());
  for (int y = 0, i = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x, ++i)
      film.at(x, y) = colour_of_share(map.values()[static_cast<size_t>(i)]);
  }
  return film;
}

Film wrong_pixels_picture(const Film& picture, const Film& reference, const FlipMap& map) {
  // A third of the light stays well below the colours; these begin where they can be told from greys.
  constexpr double grey_share = 1.0 / 3, first_share = 0.4;
  Film film(map.width(), map.height());
  for (int y = 0, i = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x, ++i) {
      const Vec3f& expected = reference.at(x, y);
      if (is_wrong(picture.at(x, y), expected)) {
        const double value = map.values()[static_cast<size_t>(i)];
        film.at(x, y) = colour_of_share(first_share + (1 - first_share) * value);
      } else {
        const double light = std::clamp(rgb_to_relative_xyz(Vec3d(expected)).y, 0.0, 1.0);
        const auto grey = static_cast<float>(grey_share * light);
        film.at(x, y) = {grey, grey, grey};
      }
    }
  }
  return film;
}

}  // namespace raysweep
