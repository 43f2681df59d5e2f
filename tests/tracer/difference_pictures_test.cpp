// What differences look like.
#include "tracer/difference_pictures.h"

#include <gtest/gtest.h>

#include "tracer/display_colour.h"

namespace raysweep {
namespace {

TEST(difference_pictures, colours_go_from_black_to_white_and_get_lighter_all_the_way) {
  EXPECT_EQ(colour_of_share(0), (Vec3f(0, 0, 0)));
  EXPECT_NEAR(length(colour_of_share(1) - Vec3f(1, 1, 1)), 0, 1e-6);
  constexpr int steps = 64;
  for (int i = 0; i < steps; ++i) {
    const auto lightness = [](int step) {
      return rgb_to_lab(Vec3d(colour_of_share(static_cast<double>(step) / steps))).x;
    };
    const double growth = lightness(i + 1) - lightness(i);
    EXPECT_GT(growth, 0.4 * 100 / steps) << i;
    EXPECT_LT(growth, 2.2 * 100 / steps) << i;
  }
}

TEST(difference_pictures, a_map_shows_each_pixel_at_its_place) {
  const Film film = picture_of(FlipMap(2, 3, {0, 0.1f, 0.2f, 0.3f, 0.4f, 1}));
  EXPECT_EQ(film.at(1, 0), colour_of_share(0.1f));
  EXPECT_EQ(film.at(0, 2), colour_of_share(0.4f));
}

TEST(difference_pictures, wrong_pixels_are_coloured_in_a_grey_picture) {
  Film picture(3, 1), reference(3, 1);
  reference.fill({0.2f, 0.4f, 0.6f});
  picture.fill({0.2f, 0.4f, 0.6f});
  picture.at(1, 0) = {0.2f, 0.401f, 0.6f};  // not one step of 8 bit
  picture.at(2, 0) = {0.2f, 0.4f, 0.3f};
  const Film film = wrong_pixels_picture(picture, reference, FlipMap(3, 1, {0, 0.01f, 0}));
  for (const int x : {0, 1}) {
    const Vec3f grey = film.at(x, 0);
    EXPECT_EQ(grey.x, grey.y);
    EXPECT_EQ(grey.y, grey.z);
    EXPECT_NEAR(grey.x, (0.2126 * 0.2 + 0.7152 * 0.4 + 0.0722 * 0.6) / 3, 1e-4);
  }
  const Vec3f wrong = film.at(2, 0);
  EXPECT_GT(wrong.x, 2 * wrong.y) << "even where ꟻLIP is 0 it is no grey";
}

}  // namespace
}  // namespace raysweep
