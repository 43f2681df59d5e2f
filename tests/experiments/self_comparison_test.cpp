#include "experiments/self_comparison.h"

#include <gtest/gtest.h>

#include <cmath>

namespace raysweep {
namespace {

/// Frames take 1, 2, 1, 2, … seconds.
class Alternating final : public Launcher {
 public:
  int launched = 0, fails_at = -1;
  LaunchOutcome launch(const Cell&, double, double) override {
    if (launched == fails_at) return {std::nullopt, "killed by signal 9", false};
    Record r;
    r.frame_seconds = {{launched++ % 2 == 0 ? 1.0 : 2.0}};
    return {r, {}, false};
  }
  LaunchOutcome picture(const Cell&, double) override { return {}; }
};

TEST(self_comparison, pairs_are_launches_one_right_after_the_other) {
  Alternating launcher;
  const SelfComparison comparison = compare_with_itself(self_comparison_cell(2), 5, 0.1, launcher);
  EXPECT_EQ(comparison.failure, "");
  EXPECT_EQ(launcher.launched, 10);
  ASSERT_EQ(comparison.log_ratios.size(), 5u);
  for (const double ratio : comparison.log_ratios) EXPECT_DOUBLE_EQ(ratio, std::log(0.5));
}

TEST(self_comparison, a_launch_that_fails_ends_it_with_the_reason) {
  Alternating launcher;
  launcher.fails_at = 5;
  const SelfComparison comparison = compare_with_itself(self_comparison_cell(2), 5, 0.1, launcher);
  EXPECT_EQ(comparison.failure, "killed by signal 9");
  EXPECT_EQ(comparison.log_ratios.size(), 2u) << "whole pairs only";
}

TEST(self_comparison, is_of_as_many_threads_as_there_are_processors) {
  EXPECT_EQ(self_comparison_cell(8).threads, 8);
  EXPECT_EQ(self_comparison_cell(1).scheduler, "serial");
}

}  // namespace
}  // namespace raysweep
