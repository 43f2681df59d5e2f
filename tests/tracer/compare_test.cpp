#include "tracer/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace raysweep {
namespace {

constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();

std::string problem(const Film& a, const std::vector<uint32_t>& ids, const Film& b) {
  try {
    (void)compare(a, ids, b, {});
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

TEST(compare, identical_pictures_do_not_differ) {
  Film film(3, 2);
  film.at(1, 1) = {0.5f, -2, 1e20f};
  const std::vector<uint32_t> ids{0, 1, 2, 3, 4, 0xffffffff};
  const PictureDifference d = compare(film, ids, film, ids);
  EXPECT_EQ(d.rmse, 0);
  EXPECT_EQ(d.relative_mse, 0);
  EXPECT_EQ(d.max_8bit, 0);
  EXPECT_EQ(d.differing_pixels, 0u);
  EXPECT_EQ(d.wrong_pixels, 0u);
  EXPECT_EQ(d.non_finite, 0u);
  EXPECT_EQ(d.differing_hits, 0u);
  EXPECT_TRUE(d.hits_known);
}

TEST(compare, means_are_over_channels_and_pixels) {
  Film picture(2, 1), reference(2, 1);
  picture.at(0, 0) = {1, 0, 0};
  reference.at(0, 0) = {0.5f, 0, 0};
  picture.at(1, 0) = {0, 0, 0.25f};
  const PictureDifference d = compare(picture, {}, reference, {});
  EXPECT_DOUBLE_EQ(d.rmse, std::sqrt((0.25 + 0.0625) / 6));
  EXPECT_DOUBLE_EQ(d.relative_mse, (0.25 / 0.26 + 0.0625 / 0.01) / 6) << "relative to the reference";
}

/// 0.5 is 188 in sRGB and 0.25 is 137 (IEC 61966-2-1); what is clamped alike looks alike.
TEST(compare, bytes_are_compared_as_they_are_shown) {
  Film picture(4, 1), reference(4, 1);
  picture.at(0, 0) = {0, 0.5f, 0};
  reference.at(0, 0) = {0, 0.25f, 0};
  picture.at(1, 0) = {2, -1, 0};
  reference.at(1, 0) = {1, 0, 1e-5f};
  picture.at(2, 0) = {0.25f, 0.25f, 0.25f};
  const PictureDifference d = compare(picture, {}, reference, {});
  EXPECT_EQ(d.max_8bit, 137);
  EXPECT_EQ(d.differing_pixels, 2u);
  EXPECT_EQ(compare(reference, {}, picture, {}).max_8bit, 137);
}

/// In sRGB 0.25 is 136.96 and 0.252 is 137.45: bytes 137 and 137; 0.255 is 138, 0.26 is 139.
TEST(compare, a_pixel_is_wrong_from_two_steps_of_8_bit_on) {
  Film picture(4, 1), reference(4, 1);
  reference.fill({0.25f, 0.25f, 0.25f});
  picture.at(0, 0) = {0.25f, 0.252f, 0.25f};
  picture.at(1, 0) = {0.255f, 0.255f, 0.255f};
  picture.at(2, 0) = {0.25f, 0.26f, 0.25f};
  picture.at(3, 0) = {nan, 0.25f, 0.25f};
  const PictureDifference d = compare(picture, {}, reference, {});
  EXPECT_EQ(d.differing_pixels, 3u);
  EXPECT_EQ(d.wrong_pixels, 2u);
}

TEST(compare, a_pixel_that_is_not_finite_is_counted_and_left_out_of_the_means) {
  Film picture(4, 1), reference(4, 1);
  picture.at(0, 0) = {nan, 0, 0};
  reference.at(1, 0) = {0, -inf, 0};
  picture.at(2, 0) = reference.at(2, 0) = {inf, inf, inf};
  picture.at(3, 0) = {0, 0, 3};
  const PictureDifference d = compare(picture, {}, reference, {});
  EXPECT_EQ(d.non_finite, 3u);
  EXPECT_DOUBLE_EQ(d.rmse, std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(d.relative_mse, 300);
  EXPECT_EQ(d.differing_pixels, 1u) << "NaN and minus infinity are shown black";
}

TEST(compare, without_a_finite_pixel_there_is_no_mean) {
  Film picture(1, 1);
  picture.fill({nan, nan, nan});
  const PictureDifference d = compare(picture, {}, picture, {});
  EXPECT_TRUE(std::isnan(d.rmse));
  EXPECT_TRUE(std::isnan(d.relative_mse));
  EXPECT_EQ(d.non_finite, 1u);
}

TEST(compare, hits_are_compared_where_both_are_known) {
  const Film film(3, 1);
  const std::vector<uint32_t> a{1, 2, 3}, b{1, 5, 0xffffffff};
  EXPECT_EQ(compare(film, a, film, b).differing_hits, 2u);
  EXPECT_EQ(compare(film, a, film, b).holes, 0u) << "it sees something where the reference sees nothing";
  EXPECT_EQ(compare(film, b, film, a).holes, 1u);
  EXPECT_FALSE(compare(film, a, film, {}).hits_known);
  EXPECT_FALSE(compare(film, {}, film, b).hits_known);
  EXPECT_EQ(compare(film, {}, film, b).differing_hits, 0u);
}

TEST(compare, what_does_not_fit_together_is_told) {
  EXPECT_EQ(problem(Film(3, 2), {}, Film(2, 3)),
            "pictures of different size cannot be compared: 3 × 2 pixels, the reference 2 × 3");
  EXPECT_EQ(problem(Film(3, 2), {1, 2}, Film(3, 2)), "2 hit ids do not belong to a picture of 3 × 2 pixels");
}

}  // namespace
}  // namespace raysweep
