// The rules of claims, as functions of numbers.
#include "results/claims/rules.h"

#include <gtest/gtest.h>

namespace raysweep {
namespace {

TEST(rules, the_best_of_those_expected_is_compared_with_the_best_of_the_others) {
  EXPECT_DOUBLE_EQ(largest_against({1, 6}, {3, 2}), 2);
  EXPECT_DOUBLE_EQ(largest_against({3}, {4}), 0.75);
  EXPECT_DOUBLE_EQ(smallest_against({2, 9}, {3, 4}), 1.5);
  EXPECT_DOUBLE_EQ(smallest_against({4}, {3}), 0.75);
}

TEST(rules, a_spread_is_the_largest_by_the_smallest) {
  EXPECT_DOUBLE_EQ(spread({4, 2, 3}), 2);
  EXPECT_DOUBLE_EQ(spread({5}), 1);
  EXPECT_DOUBLE_EQ(spread({0, 0}), 1) << "no failures anywhere are no spread";
}

TEST(rules, neighbours_out_of_order_are_below_one) {
  EXPECT_DOUBLE_EQ(least_neighbour_ratio({8, 4, 2}, false), 2);
  EXPECT_DOUBLE_EQ(least_neighbour_ratio({8, 4, 5}, false), 0.8);
  EXPECT_DOUBLE_EQ(least_neighbour_ratio({2, 3, 6}, true), 1.5);
  EXPECT_DOUBLE_EQ(least_neighbour_ratio({0, 0, 1}, true), 1);
}

TEST(rules, residuals_are_those_of_a_line_through_the_origin_or_not) {
  EXPECT_NEAR(largest_residual({1, 2, 3}, {2, 4, 6}, false), 0, 1e-12);
  EXPECT_NEAR(largest_residual({1, 2, 3}, {3, 5, 7}, true), 0, 1e-12);
  // Through the origin the best slope for (1, 3), (2, 5) is 13/5: 0.4 off 3, 0.2 off 5.
  EXPECT_NEAR(largest_residual({1, 2}, {3, 5}, false), 0.4 / 3, 1e-12);
}

}  // namespace
}  // namespace raysweep
