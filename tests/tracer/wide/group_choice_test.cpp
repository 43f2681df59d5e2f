#include "tracer/wide/group_choice.h"

#include <gtest/gtest.h>

namespace raysweep {
namespace {

constexpr int32_t budget = 96;

/// Groups that take as long alone as `steps` of a packet.
GroupCost alone_as_long_as(uint64_t steps) {
  GroupCost cost;
  cost.add(22 * steps * 100, 100);
  return cost;
}

/// How many of `count` groups go together where every `nth` of those gives up.
int together(const GroupCost& alone, int count, int nth, int32_t steps_of_the_others) {
  GroupChoice choice(alone, budget);
  int tried = 0;
  for (int i = 0; i < count; ++i) {
    if (!choice.together()) continue;
    ++tried % nth == 0 ? choice.gave_up(budget) : choice.ended(steps_of_the_others);
  }
  return tried;
}

TEST(group_choice, goes_together_as_long_as_that_pays) {
  EXPECT_EQ(together(alone_as_long_as(150), 1000, 6, 50), 1000);
  EXPECT_EQ(together({}, 1000, 2, 50), 1000);  // nothing is known of single rays yet
}

TEST(group_choice, goes_alone_where_most_give_up) {
  const int tried = together(alone_as_long_as(150), 10000, 1, 0);
  EXPECT_GT(tried, 100);  // tries again from time to time
  EXPECT_LT(tried, 600);
}

TEST(group_choice, asks_what_rays_take_alone) {
  EXPECT_EQ(together(alone_as_long_as(250), 1000, 2, 50), 1000);
  EXPECT_LT(together(alone_as_long_as(100), 1000, 2, 50), 300);
}

TEST(group_choice, an_end_that_took_longer_than_alone_is_a_loss) {
  EXPECT_LT(together(alone_as_long_as(40), 10000, 1 << 30, 60), 1000);
}

TEST(group_choice, costs_follow_what_comes_later) {
  GroupCost cost;
  for (int i = 0; i < 100; ++i) cost.add(1000 * 500, 1000);
  for (int i = 0; i < 100; ++i) cost.add(1000 * 2000, 1000);
  EXPECT_NEAR(static_cast<double>(cost.cycles) / static_cast<double>(cost.groups), 2000, 1);
}

}  // namespace
}  // namespace raysweep
