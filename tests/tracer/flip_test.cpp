// ꟻLIP: what it must be by its definition, and what another way to compute it gives (flip_values.py).
#include "tracer/flip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "tracer/display_colour.h"
#include "tracer/film.h"

namespace raysweep {
namespace {

constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();

Film plain(const Vec3f& colour, int width = 5, int height = 4) {
  Film film(width, height);
  film.fill(colour);
  return film;
}

/// Black, and white from column `edge` on.
Film stripes(int edge) {
  Film film(24, 16);
  for (int y = 0; y < 16; ++y) {
    for (int x = edge; x < 24; ++x) film.at(x, y) = {1, 1, 1};
  }
  return film;
}

/// Red grows rightwards, from column `shift` on, green downwards; blue jumps from pixel to pixel.
Film colours(int shift) {
  Film film(30, 20);
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 30; ++x) {
      film.at(x, y) = {static_cast<float>((x + shift) % 30) / 29, static_cast<float>(y) / 19,
                       static_cast<float>((7 * x + 3 * y) % 11) / 10};
    }
  }
  return film;
}

Film dot_on_grey() {
  Film film = plain({0.25f, 0.25f, 0.25f}, 21, 21);
  film.at(10, 10) = {1, 0.5f, 0};
  return film;
}

double largest_difference(const FlipMap& a, const FlipMap& b) {
  double largest = 0;
  for (size_t i = 0; i < a.values().size(); ++i)
    largest = std::max(largest, std::abs(double(a.values()[i]) - b.values()[i]));
  return largest;
}

TEST(flip, of_equal_pictures_is_0_everywhere) {
  for (const Film& film : {stripes(12), colours(0), plain({nan, inf, -1})})
    EXPECT_EQ(flip(film, film).max(), 0);
}

/// Both are the ends of the scale by definition: no two colours of a display are further apart.
TEST(flip, of_green_and_blue_is_1) { EXPECT_NEAR(flip(plain({0, 1, 0}), plain({0, 0, 1})).mean(), 1, 1e-6); }

/// Without edges no filter changes anything, and of L* = 0 and 100 only lightness differs: HyAB is 100. It is
/// 203.3 of green and blue; with both to the power 0.7, (100/203.3)^0.7 = 0.6086 is above the knee 0.4.
TEST(flip, of_black_and_white_is_what_their_lightness_makes_it) {
  const double largest = hyab(hunt_adjusted(rgb_to_lab({0, 1, 0})), hunt_adjusted(rgb_to_lab({0, 0, 1})));
  const double expected = 0.95 + 0.05 * (std::pow(100 / largest, 0.7) - 0.4) / 0.6;
  const FlipMap map = flip(plain({0, 0, 0}), plain({1, 1, 1}));
  EXPECT_NEAR(map.mean(), expected, 1e-6);
  EXPECT_NEAR(map.mean(), 0.96737976, 1e-6);
  EXPECT_EQ(map.quantile(0), map.quantile(1));
}

/// L* of the display's colours as CIE 1976 defines it, and a*, b* of no colour: both 0.
TEST(flip, greys_have_no_colour) {
  for (const double grey : {0.0, 0.001, 0.18, 1.0}) {
    const Vec3d lab = rgb_to_lab({grey, grey, grey});
    EXPECT_NEAR(lab.x, grey > 0.01 ? 116 * std::cbrt(grey) - 16 : 903.2963 * grey, 1e-4);
    EXPECT_NEAR(lab.y, 0, 1e-12);
    EXPECT_NEAR(lab.z, 0, 1e-12);
  }
}

TEST(flip, opponent_colours_lead_back) {
  const Vec3d colour{0.1, 0.7, 0.4}, back = opponent_to_rgb(rgb_to_opponent(colour));
  EXPECT_NEAR(length(back - colour), 0, 1e-14);
}

struct Expected {
  double pixels_per_degree, mean, max, first, middle;
};

void expect_values(const Film& a, const Film& b, const Expected& expected) {
  SCOPED_TRACE(expected.pixels_per_degree);
  const FlipMap map = flip(a, b, expected.pixels_per_degree);
  const size_t middle = static_cast<size_t>(a.height() / 2) * static_cast<size_t>(a.width()) +
                        static_cast<size_t>(a.width() / 2);
  EXPECT_NEAR(map.mean(), expected.mean, 1e-6);
  EXPECT_NEAR(map.max(), expected.max, 1e-6);
  EXPECT_NEAR(map.values()[0], expected.first, 1e-6);
  EXPECT_NEAR(map.values()[middle], expected.middle, 1e-6);
}

// Printed by flip_values.py, which filters by whole two-dimensional kernels.
TEST(flip, is_what_another_way_to_compute_it_gives) {
  constexpr double paper = paper_pixels_per_degree;
  expect_values(stripes(12), stripes(13), {paper, 0.13792674, 0.77291644, 0, 0.53817374});
  expect_values(stripes(12), stripes(13), {20, 0.08358430, 0.96562976, 0, 0.96562976});
  expect_values(colours(0), colours(1), {paper, 0.15216056, 0.82219350, 0.14452821, 0.09486696});
  expect_values(colours(0), colours(1), {20, 0.12671251, 0.97169101, 0, 0.09762560});
  const Film grey = plain({0.25f, 0.25f, 0.25f}, 21, 21);
  expect_values(dot_on_grey(), grey, {paper, 0.01490784, 0.24827566, 0.00001917, 0.24827566});
  expect_values(dot_on_grey(), grey, {20, 0.00816626, 0.81107338, 0, 0.81107338});
  expect_values(plain({1, 0, 0}), plain({0.25f, 0.25f, 0.25f}),
                {paper, 0.95192587, 0.95192587, 0.95192587, 0.95192587});
}

TEST(flip, is_symmetric) {
  const Film a = colours(0), b = colours(3);
  EXPECT_EQ(largest_difference(flip(a, b), flip(b, a)), 0);
}

TEST(flip, grows_with_the_difference) {
  double before = 0;
  for (const float red : {0.31f, 0.35f, 0.5f, 0.8f, 1.0f}) {
    const double now = flip(plain({red, 0.3f, 0.3f}), plain({0.3f, 0.3f, 0.3f})).mean();
    EXPECT_GT(now, before) << red;
    before = now;
  }
}

TEST(flip, a_dot_is_seen_less_from_further_away) {
  const Film grey = plain({0.25f, 0.25f, 0.25f}, 21, 21);
  EXPECT_LT(flip(dot_on_grey(), grey, 60).max(), flip(dot_on_grey(), grey, 30).max());
}

TEST(flip, a_moved_edge_is_seen_near_it_alone) {
  const FlipMap map = flip(stripes(12), stripes(13), 20);
  EXPECT_GT(map.values()[12], 0.9);
  EXPECT_EQ(map.values()[0], 0);
}

TEST(flip, is_of_what_a_display_shows) {
  const FlipMap none = flip(plain({2, -1, nan}), plain({1, 0, 0}));
  EXPECT_EQ(none.max(), 0);
  EXPECT_GT(flip(plain({1, 0, inf}), plain({1, 0, 0})).max(), 0.9) << "infinity is as bright as can be";
}

TEST(flip, quantiles_lie_between_the_values) {
  const FlipMap map(2, 2, {0.5f, 0.0f, 1.0f, 0.25f});
  EXPECT_EQ(map.mean(), 0.4375);
  EXPECT_EQ(map.max(), 1);
  EXPECT_EQ(map.quantile(0), 0);
  EXPECT_EQ(map.quantile(0.5), 0.375);
  EXPECT_EQ(map.quantile(1), 1);
}

TEST(flip, of_pictures_of_different_size_there_is_none) {
  try {
    (void)flip(Film(3, 2), Film(2, 3));
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "pictures of different size cannot be compared: 3 × 2 pixels, the reference 2 × 3");
  }
}

}  // namespace
}  // namespace raysweep
