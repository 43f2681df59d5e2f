#include "results/statistics/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace raysweep {
namespace {

TEST(median, is_the_middle_or_the_mean_of_the_middle_two) {
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1, 3, 2}), 2.5);
  EXPECT_EQ(median({7}), 7);
}

/// Conover 1999, "Practical Nonparametric Statistics", table A3 (binomial, p = 0.5): ranks of 95 % intervals.
TEST(median_interval, ranks_are_those_of_the_binomial_table) {
  for (const int n : {1, 2, 3, 4, 5}) EXPECT_FALSE(median_interval_rank(n)) << n;
  const std::pair<int, int> table[] = {{6, 0},  {7, 0},  {8, 0},  {9, 1},  {11, 1}, {12, 2},
                                       {15, 3}, {20, 5}, {25, 7}, {30, 9}, {50, 17}};
  for (const auto& [n, rank] : table) EXPECT_EQ(median_interval_rank(n), rank) << n;
}

TEST(median_interval, ranks_of_many_samples_follow_the_normal_approximation) {
  for (const int n : {1000, 1100, 2000, 10000}) {
    EXPECT_NEAR(*median_interval_rank(n), n / 2.0 - 1.96 * std::sqrt(n) / 2, 2) << n;
  }
}

// 0.999^2995 is the first power below 0.05. Of ten thousand about ten are beyond; four or fewer in 2.9 %.
TEST(upper_bound, of_a_quantile_leaves_out_as_few_as_chance_allows) {
  EXPECT_FALSE(upper_bound_rank(2994, 0.999));
  EXPECT_EQ(upper_bound_rank(2995, 0.999), 0);
  EXPECT_EQ(upper_bound_rank(10'000, 0.999), 4);
  EXPECT_EQ(upper_bound_rank(59, 0.95), 0) << "the known 59 of 95 % at 95 %";
  EXPECT_FALSE(upper_bound_rank(58, 0.95));
  EXPECT_FALSE(upper_bound_rank(0, 0.5));
}

TEST(median_interval, covers_the_true_median_at_least_95_times_of_100) {
  std::mt19937 random(5);
  std::lognormal_distribution<double> skewed(0, 1);  // median exactly 1
  for (const int n : {6, 7, 15}) {
    int covered = 0;
    constexpr int trials = 20000;
    for (int trial = 0; trial < trials; ++trial) {
      std::vector<double> samples(static_cast<size_t>(n));
      for (double& s : samples) s = skewed(random);
      const auto interval = estimate_median(samples).interval;
      covered += interval->low <= 1 && 1 <= interval->high;
    }
    EXPECT_GT(covered, trials * 0.945) << n;  // three standard errors below 95 %
  }
}

TEST(estimate, tells_its_relative_half_width) {
  const Estimate e = estimate_median({9, 10, 10, 10, 10, 11, 10});
  EXPECT_EQ(e.value, 10);
  ASSERT_TRUE(e.relative_half_width());
  EXPECT_NEAR(*e.relative_half_width(), 0.1, 1e-12);
  EXPECT_FALSE(estimate_median({1, 2, 3}).relative_half_width());
}

}  // namespace
}  // namespace raysweep
