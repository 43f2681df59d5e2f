#include "results/statistics/stopping.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/results/statistics/simulated.h"

namespace raysweep {
namespace {

TEST(stopping, looks_after_twice_as_many_launches_each_time) {
  EXPECT_EQ(next_look(0, 7, 28), 7);
  EXPECT_EQ(next_look(6, 7, 28), 7);
  EXPECT_EQ(next_look(7, 7, 28), 14);
  EXPECT_EQ(next_look(14, 7, 28), 28);
  EXPECT_EQ(next_look(28, 7, 28), 28) << "no look is left";
  EXPECT_EQ(next_look(14, 7, 20), 20) << "the cap is a look";
  EXPECT_EQ(next_look(0, 7, 5), 5);
}

TEST(stopping, converges_by_the_relative_half_width_and_never_without_an_interval) {
  EXPECT_TRUE(converged(estimate_median({9.9, 10, 10, 10, 10, 10.1}), 0.02));
  EXPECT_FALSE(converged(estimate_median({9.9, 10, 10, 10, 10, 10.1}), 0.005));
  EXPECT_FALSE(converged(estimate_median({10, 10, 10}), 0.5));
}

/// How often the interval at which a cell stops covers the true median, with looks at `next`.
template <class Next>
double coverage(const std::string& kind, double truth, double target, Next&& next) {
  constexpr int trials = 5000, first = 7, cap = 28;
  Simulated draw(kind);
  int covered = 0;
  for (int i = 0; i < trials; ++i) {
    std::vector<double> fps;
    Estimate estimate;
    do {
      const int look = next(static_cast<int>(fps.size()), first, cap);
      while (static_cast<int>(fps.size()) < look) fps.push_back(std::exp(draw()));
      estimate = estimate_median(fps);
    } while (!converged(estimate, target) && fps.size() < cap);
    covered += estimate.interval->low <= truth && truth <= estimate.interval->high;
  }
  return covered / double(trials);
}

int after_each_launch(int launches, int first, int) { return std::max(launches + 1, first); }

struct Case {
  const char* kind;
  double truth, target;
};
// Targets that most cells reach at the first look, that some reach on the way, and that few reach at all.
const Case cases[] = {{"normal", 1, 0.03},
                      {"normal", 1, 0.02},
                      {"normal", 1, 0.015},
                      {"normal", 1, 0.01},
                      {"bimodal", std::exp(-0.1397 * 0.005), 0.005},
                      {"bimodal", std::exp(-0.1397 * 0.005), 0.003},
                      {"log-normal", std::exp(-0.02), 0.02},
                      {"log-normal", std::exp(-0.02), 0.01}};

TEST(stopping, few_looks_keep_the_coverage_of_the_interval) {
  double least = 1;
  for (const auto& [kind, truth, target] : cases) {
    const double rate = coverage(kind, truth, target, next_look);
    least = std::min(least, rate);
    EXPECT_GE(rate, 0.95) << kind << " " << target;
  }
  RecordProperty("least", std::to_string(least));
}

TEST(stopping, a_look_after_each_launch_picks_intervals_that_are_narrow_by_chance) {
  double least = 1;
  for (const auto& [kind, truth, target] : cases)
    least = std::min(least, coverage(kind, truth, target, after_each_launch));
  RecordProperty("least", std::to_string(least));
  EXPECT_LT(least, 0.945) << "why there are few looks";
}

}  // namespace
}  // namespace raysweep
