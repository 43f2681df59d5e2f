#include "tracer/sample/pattern.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>

namespace raysweep {
namespace {

class Pattern : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(all, Pattern, testing::Values("grid", "circle"),
                         [](const auto& info) { return info.param; });

TEST_P(Pattern, has_as_many_points_as_asked_inside_the_pixel_balanced_around_its_centre) {
  for (int count = 1; count <= 200; ++count) {
    const auto points = make_pattern(GetParam(), count);
    ASSERT_EQ(points.size(), static_cast<size_t>(count));
    double x = 0, y = 0;
    for (const Subpixel& p : points) {
      EXPECT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1);
      x += p.x / count;
      y += p.y / count;
    }
    EXPECT_NEAR(x, 0.5, 1e-9) << count;
    EXPECT_NEAR(y, 0.5, 1e-9) << count;
  }
}

TEST_P(Pattern, one_subpixel_is_the_centre) {
  const auto points = make_pattern(GetParam(), 1);
  EXPECT_EQ(points[0].x, 0.5);
  EXPECT_EQ(points[0].y, 0.5);
}

TEST(grid, nine_points_are_three_by_three) {
  const auto points = make_pattern("grid", 9);
  for (int i = 0; i < 9; ++i) {
    EXPECT_NEAR(points[static_cast<size_t>(i)].x, (i % 3 + 0.5) / 3, 1e-12);
    EXPECT_NEAR(points[static_cast<size_t>(i)].y, (i / 3 + 0.5) / 3, 1e-12);
  }
}

TEST(grid, seven_points_fill_three_rows_of_equal_cells) {
  const auto points = make_pattern("grid", 7);
  std::multiset<double> rows;
  for (const Subpixel& p : points) rows.insert(p.y);
  const std::set<double> distinct(rows.begin(), rows.end());
  ASSERT_EQ(distinct.size(), 3u);
  for (const double y : distinct) EXPECT_TRUE(rows.count(y) == 2 || rows.count(y) == 3);
}

TEST(circle, four_points_are_the_rotated_grid) {
  std::set<long> columns, rows;
  for (const Subpixel& p : make_pattern("circle", 4)) {
    columns.insert(std::lround(p.x * 100));
    rows.insert(std::lround(p.y * 100));
    EXPECT_NEAR(std::hypot(p.x - 0.5, p.y - 0.5), 1 / std::sqrt(6), 1e-12);
  }
  EXPECT_EQ(columns.size(), 4u);
  EXPECT_EQ(rows.size(), 4u);
}

TEST(pattern, an_unknown_name_is_refused) {
  EXPECT_THROW((void)make_pattern("spiral", 4), std::invalid_argument);
}

}  // namespace
}  // namespace raysweep
