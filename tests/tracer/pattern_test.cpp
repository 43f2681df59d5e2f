#include "tracer/sample/pattern.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

#include "tracer/settings.h"

namespace raysweep {
namespace {

int digit_sum(int n, int base) { return n == 0 ? 0 : n % base + digit_sum(n / base, base); }

/// How far a coordinate's mean may lie from the centre. The first n points of a digital sequence are runs of
/// base^k points, as many as the digits of n sum to; a run has one point in each of base^k strata, so its sum
/// is off by half a pixel at most. Halton's points are moved by another half over n.
double tolerance(const std::string& pattern, int count, int base) {
  if (pattern.starts_with("sobol")) return digit_sum(count, 2) / (2.0 * count);
  if (pattern == "halton") return (digit_sum(count, base) + 1) / (2.0 * count);
  return 1e-9;
}

class Pattern : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(all, Pattern,
                         testing::Values("grid", "rotated_grid", "circle", "circle:0.5", "circle:0.5:0",
                                         "circle:0.1:0.99", "halton", "sobol", "sobol:4294967295"),
                         [](const auto& info) {
                           std::string name = info.param;
                           for (char& c : name) c = std::isalnum(c) ? c : '_';
                           return name;
                         });

TEST_P(Pattern, has_as_many_points_as_asked_inside_the_pixel_in_float_too) {
  for (int count = 1; count <= 300; ++count) {
    const auto points = make_pattern(GetParam(), count);
    ASSERT_EQ(points.size(), static_cast<size_t>(count));
    for (const Subpixel& p : points) {
      EXPECT_TRUE(p.x >= 0 && static_cast<float>(p.x) < 1 && p.y >= 0 && static_cast<float>(p.y) < 1)
          << count << ": " << p.x << ' ' << p.y;
    }
  }
}

TEST_P(Pattern, is_balanced_around_the_centre) {
  for (int count = 1; count <= 300; ++count) {
    double x = 0, y = 0;
    for (const Subpixel& p : make_pattern(GetParam(), count)) {
      x += p.x / count;
      y += p.y / count;
    }
    EXPECT_NEAR(x, 0.5, count == 1 ? 0 : tolerance(GetParam(), count, 2) + 1e-7) << count;
    EXPECT_NEAR(y, 0.5, count == 1 ? 0 : tolerance(GetParam(), count, 3) + 1e-7) << count;
  }
}

TEST_P(Pattern, has_no_point_twice) {
  for (const int count : {2, 3, 4, 5, 16, 97, 300, 65536}) {
    std::set<std::pair<double, double>> distinct;
    for (const Subpixel& p : make_pattern(GetParam(), count)) distinct.emplace(p.x, p.y);
    EXPECT_EQ(distinct.size(), static_cast<size_t>(count));
  }
}

TEST_P(Pattern, one_subpixel_is_the_centre) {
  const auto points = make_pattern(GetParam(), 1);
  ASSERT_EQ(points.size(), 1u);
  EXPECT_EQ(points[0].x, 0.5);
  EXPECT_EQ(points[0].y, 0.5);
}

TEST_P(Pattern, is_the_same_whenever_it_is_made) {
  const auto a = make_pattern(GetParam(), 33), b = make_pattern(GetParam(), 33);
  for (size_t i = 0; i < a.size(); ++i) EXPECT_TRUE(a[i].x == b[i].x && a[i].y == b[i].y);
}

TEST_P(Pattern, has_no_problem) { EXPECT_EQ(pattern_problem(GetParam()), ""); }

TEST(pattern, every_listed_name_is_one) {
  for (const Choice& choice : patterns()) EXPECT_EQ(pattern_problem(std::string(choice.name)), "");
}

TEST(pattern, what_is_wrong_is_told_with_what_is_possible) {
  const std::string possible =
      "; possible: grid, rotated_grid, circle, circle:RADIUS, circle:RADIUS:PHASE, halton, sobol, sobol:SEED";
  for (const std::string unknown : {"spiral", "", "Grid", "grid:3", "halton:1", "circles", " sobol"})
    EXPECT_EQ(pattern_problem(unknown), "unknown pattern \"" + unknown + "\"" + possible);
  for (const std::string radius : {"0.7", "0", "-0.1", "nan", "inf", "", "0.3x", " 0.3", "1e-400", ":0.5"})
    EXPECT_EQ(pattern_problem("circle:" + radius),
              "circle:" + radius + ": the radius must be above 0 and at most 0.5 pixels");
  for (const std::string phase : {"1", "-0.1", "nan", "", "0.5:", "0.5:0.5", "0,5"})
    EXPECT_EQ(pattern_problem("circle:0.3:" + phase),
              "circle:0.3:" + phase + ": the phase must be at least 0 and below 1 step between points");
  for (const std::string seed : {"4294967296", "-1", "", "1.5", "0x1", "7 "})
    EXPECT_EQ(pattern_problem("sobol:" + seed),
              "sobol:" + seed + ": the seed must be a whole number from 0 to 4294967295");
}

TEST(pattern, what_has_a_problem_is_not_made) {
  for (const std::string wrong : {"spiral", "circle:0.7", "sobol:x"}) {
    for (const int count : {1, 4}) {
      try {
        (void)make_pattern(wrong, count);
        ADD_FAILURE() << wrong;
      } catch (const std::invalid_argument& error) {
        EXPECT_EQ(error.what(), pattern_problem(wrong));
      }
    }
  }
  EXPECT_THROW((void)make_pattern("grid", 0), std::invalid_argument);
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

TEST(rotated_grid, four_points_are_a_grid_turned_by_atan_one_half) {
  const auto p = make_pattern("rotated_grid", 4);
  const double y[] = {0.625, 0.125, 0.875, 0.375};
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(p[i].x, (static_cast<double>(i) + 0.5) / 4);
    EXPECT_EQ(p[i].y, y[i]);
  }
  EXPECT_EQ((p[1].x - p[0].x) * 2, p[0].y - p[1].y) << "a side of the square, 1 across and 2 up";
}

TEST(rotated_grid, every_column_and_every_row_holds_one_point) {
  for (int count = 1; count <= 257; ++count) {
    std::set<long> columns, rows;
    for (const Subpixel& p : make_pattern("rotated_grid", count)) {
      columns.insert(std::lround(p.x * count - 0.5));
      rows.insert(std::lround(p.y * count - 0.5));
      EXPECT_NEAR(p.y * count - 0.5, static_cast<double>(std::lround(p.y * count - 0.5)), 1e-9);
    }
    EXPECT_EQ(columns.size(), static_cast<size_t>(count));
    EXPECT_EQ(rows.size(), static_cast<size_t>(count));
    EXPECT_EQ(*rows.begin(), 0);
    EXPECT_EQ(*rows.rbegin(), count - 1);
  }
}

/// A hexagonal lattice, the best of all, has points 1.0746/√n apart.
TEST(rotated_grid, points_keep_apart) {
  for (int count = 4; count <= 257; ++count) {
    const auto points = make_pattern("rotated_grid", count);
    double nearest = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < points.size(); ++i) {
      for (size_t j = 0; j < i; ++j)
        nearest = std::min(nearest, std::hypot(points[i].x - points[j].x, points[i].y - points[j].y));
    }
    EXPECT_GT(nearest * std::sqrt(count), 0.8) << count;
  }
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

TEST(circle, radius_and_phase_are_as_asked) {
  for (const Subpixel& p : make_pattern("circle:0.25", 7))
    EXPECT_NEAR(std::hypot(p.x - 0.5, p.y - 0.5), 0.25, 1e-12);
  const auto first = [](const char* pattern) { return make_pattern(pattern, 4)[0]; };
  EXPECT_NEAR(first("circle:0.25:0").x, 0.75, 1e-12);
  EXPECT_NEAR(first("circle:0.25:0").y, 0.5, 1e-12);
  EXPECT_NEAR(first("circle:0.25:0.5").x, 0.5 + 0.25 / std::sqrt(2), 1e-12) << "half a quarter turn";
  EXPECT_NEAR(first("circle:0.25:0.5").y, 0.5 + 0.25 / std::sqrt(2), 1e-12);
  EXPECT_EQ(first("circle").x, first("circle:0.4082482904638631").x);
  EXPECT_EQ(first("circle:0.25").x, first("circle:0.25:0.2").x);
}

/// Whether each of `columns` × `rows` equal boxes of the pixel holds one of the points.
bool every_box_holds_one(const std::vector<Subpixel>& points, int columns, int rows) {
  std::set<std::pair<int, int>> boxes;
  for (const Subpixel& p : points)
    boxes.emplace(static_cast<int>(p.x * columns), static_cast<int>(p.y * rows));
  return boxes.size() == points.size() &&
         points.size() == static_cast<size_t>(columns) * static_cast<size_t>(rows);
}

TEST(halton, every_box_of_powers_of_two_columns_and_of_three_rows_holds_one_point) {
  for (int columns = 1; columns <= 256; columns *= 2) {
    for (int rows = 1; rows <= 243; rows *= 3)
      EXPECT_TRUE(every_box_holds_one(make_pattern("halton", columns * rows), columns, rows))
          << columns << " × " << rows;
  }
}

class Sobol : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(seeds, Sobol,
                         testing::Values("sobol", "sobol:1", "sobol:2", "sobol:12345", "sobol:4294967295"),
                         [](const auto& info) {
                           const std::string name = info.param;
                           return name == "sobol" ? std::string("none") : name.substr(6);
                         });

/// A (0, k, 2)-net in base 2 (Niederreiter 1992).
TEST_P(Sobol, of_two_to_the_k_points_every_elementary_box_holds_one) {
  for (int k = 1; k <= 12; ++k) {
    const auto points = make_pattern(GetParam(), 1 << k);
    for (int across = 0; across <= k; ++across)
      EXPECT_TRUE(every_box_holds_one(points, 1 << across, 1 << (k - across))) << k << ' ' << across;
  }
}

/// Unscrambled, the first point is the corner 0 and coordinates are multiples of 1/count.
TEST_P(Sobol, points_are_scattered_inside_their_boxes) {
  double sum = 0, squares = 0;
  const int count = 1024;
  for (const Subpixel& p : make_pattern(GetParam(), count)) {
    const double inside = p.x * count - std::floor(p.x * count);
    sum += inside / count;
    squares += (inside - 0.5) * (inside - 0.5) / count;
  }
  EXPECT_NEAR(sum, 0.5, 0.05) << "five and a half standard errors";
  EXPECT_NEAR(squares, 1.0 / 12, 0.02);
}

TEST(sobol, a_seed_chooses_the_points_and_none_is_seed_zero) {
  const auto equal = [](const char* a, const char* b) {
    const auto p = make_pattern(a, 16), q = make_pattern(b, 16);
    int same = 0;
    for (size_t i = 0; i < p.size(); ++i) same += (p[i].x == q[i].x) + (p[i].y == q[i].y);
    return same;
  };
  EXPECT_EQ(equal("sobol", "sobol:0"), 32);
  EXPECT_EQ(equal("sobol:7", "sobol:7"), 32);
  EXPECT_EQ(equal("sobol:0", "sobol:1"), 0);
  EXPECT_EQ(equal("sobol:1", "sobol:2147483649"), 0) << "the highest bit of a seed counts";
}

}  // namespace
}  // namespace raysweep
