// Edges of pictures, and errors there.
#include "experiments/picture_edges.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace raysweep {
namespace {

/// Four by three pixels, black but for the last column.
Film with_bright_column(float value) {
  Film film(4, 3);
  for (int y = 0; y < 3; ++y) film.at(3, y) = Vec3f(value, value, value);
  return film;
}

TEST(picture_edges, are_the_pixels_on_both_sides_of_a_step_and_none_of_another_row) {
  const auto edges = edge_pixels(with_bright_column(1));
  for (size_t i = 0; i < edges.size(); ++i) EXPECT_EQ(edges[i], i % 4 >= 2) << i;
}

TEST(picture_edges, are_seen_above_and_below_too) {
  Film film(2, 3);
  film.at(0, 2) = Vec3f(0, 1, 0);
  film.at(1, 2) = Vec3f(0, 1, 0);
  EXPECT_EQ(edge_pixels(film), (std::vector<bool>{false, false, true, true, true, true}));
}

TEST(picture_edges, are_not_where_a_surface_is_shaded) {
  // 0.01 is 25 of 255, 0.02 is 39.
  for (const bool is_edge : edge_pixels(with_bright_column(0.01f))) EXPECT_FALSE(is_edge);
  EXPECT_EQ(error_at_edges(with_bright_column(1), with_bright_column(0.02f)).pixels, 6u);
}

TEST(picture_edges, errors_count_at_the_edges_of_the_reference_alone) {
  const Film reference = with_bright_column(1);
  EXPECT_EQ(error_at_edges(reference, reference).rmse, 0);
  Film film = with_bright_column(0.5f);
  film.at(0, 0) = Vec3f(9, 9, 9);  // far from any edge
  const EdgeError error = error_at_edges(film, reference);
  EXPECT_EQ(error.pixels, 6u);
  EXPECT_DOUBLE_EQ(error.rmse, std::sqrt(0.25 / 2)) << "half of them are off by a half";
}

TEST(picture_edges, leave_out_what_is_not_finite_and_refuse_other_sizes) {
  Film film = with_bright_column(1);
  film.at(3, 0) = Vec3f(NAN, 1, 1);
  EXPECT_EQ(error_at_edges(film, with_bright_column(1)).rmse, 0);
  EXPECT_TRUE(std::isnan(error_at_edges(Film(4, 3), Film(4, 3)).rmse)) << "without any edge";
  EXPECT_THROW((void)error_at_edges(Film(3, 4), film), std::invalid_argument);
}

}  // namespace
}  // namespace raysweep
