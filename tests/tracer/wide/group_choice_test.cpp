#include "tracer/wide/group_choice.h"

#include <gtest/gtest.h>

#include "tests/tracer/scene_sizes.h"
#include "tests/tracer/triangle_row.h"
#include "tests/tracer/wide/batches.h"

namespace raysweep {
namespace {

/// Of rays that take as long alone as `steps` of a packet.
GroupChoice alone_as_long_as(uint64_t steps) {
  GroupChoice choice;
  choice.went_alone(22 * steps * 100, 100 * packet_size);
  return choice;
}

/// How many of `count` groups go together where every `nth` of those gives up.
int together(GroupChoice& choice, int count, int nth, int32_t steps_of_the_others) {
  int tried = 0;
  for (int i = 0; i < count; ++i) {
    if (!choice.together()) continue;
    ++tried % nth == 0 ? choice.gave_up(GroupChoice::budget) : choice.ended(steps_of_the_others);
  }
  return tried;
}
int together(GroupChoice&& choice, int count, int nth, int32_t steps_of_the_others) {
  return together(choice, count, nth, steps_of_the_others);
}

TEST(group_choice, goes_together_as_long_as_that_pays) {
  EXPECT_EQ(together(alone_as_long_as(150), 1000, 6, 50), 1000);
  EXPECT_EQ(together(GroupChoice(), 1000, 2, 50), 1000);  // nothing is known of single rays yet
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

TEST(group_choice, follows_what_rays_take_alone_later) {
  GroupChoice choice = alone_as_long_as(250);
  for (int i = 0; i < 1000; ++i) choice.went_alone(22 * 100 * 100, 100 * packet_size);
  EXPECT_LT(together(choice, 1000, 2, 50), 300);
}

TEST(group_choice, less_than_a_group_alone_tells_nothing_yet) {
  GroupChoice choice;
  choice.went_alone(1, packet_size - 1);
  EXPECT_EQ(together(choice, 1000, 2, 50), 1000);
}

TEST(group_choice, kinds_of_rays_have_one_each) {
  KernelScratch scratch;
  scratch.begin_level(3);
  scratch.choice(false).gave_up(1 << 20);
  EXPECT_FALSE(scratch.choice(false).together());
  EXPECT_TRUE(scratch.choice(true).together());
  scratch.begin_level(1);
  EXPECT_TRUE(scratch.choice(false).together());
  scratch.begin_level(2);
  EXPECT_FALSE(scratch.choice(false).together());
}

/// Where kernels ask it and tell it what became of their packets: camera rays of a scene, once and again.
TEST(group_choice, is_asked_and_told_by_kernels) {
  constexpr size_t count = 1600;
  const Scene scene = scenes_up_to(brute_force_triangles).front().make(2);
  const ScalarCore<float, MollerTrumbore> oracle(scene, "sah", 4);
  const RayBatch rays = batch_of(make_rays<float>(scene, oracle, "primary", count, PixelOrder::blocks));
  for_each_wide_core<MollerTrumbore>(scene, "sah", 4, [&](const auto& core, std::string_view isa) {
    for (const bool any : {false, true}) {
      const auto groups_alone = [&](KernelScratch& scratch) {
        HitBatch hits(count);
        any ? core.occluded(rays, hits, scratch) : core.closest(rays, hits, scratch);
        return scratch.groups.size();
      };
      KernelScratch trusting, doubting, earning, averse;
      const size_t least = groups_alone(trusting);
      EXPECT_LT(least, count / packet_size / 2) << isa;
      doubting.choice(any).gave_up(1 << 20);
      EXPECT_GE(groups_alone(doubting), least + 30) << isa << ": thirty-one go alone, then packets do well";
      EXPECT_EQ(groups_alone(doubting), least) << isa;
      for (int i = 0; i < 2; ++i) {
        earning.choice(any).gave_up(1900);
        EXPECT_EQ(groups_alone(earning), least) << isa << ": packets earn more than that";
      }
      averse.choice(any).went_alone(1, 60000);
      averse.choice(any).gave_up(1900);
      EXPECT_GT(groups_alone(averse), count / packet_size / 2) << isa << ": packets take longer than that";
    }
  });
}

/// Without a hierarchy a packet that hits nothing has more to test than its budget.
TEST(group_choice, is_told_of_packets_that_give_up) {
  const std::vector<TestRay<float>> down_the_row(
      1600, {{{0.4f, 0.4f, 3}, {0.0001f, 0.0002f, -1}}, std::numeric_limits<float>::infinity()});
  const RayBatch rays = batch_of(down_the_row);
  for_each_wide_core<MollerTrumbore>(
      triangles_in_a_row(1000), "none", 1, [&](const auto& core, std::string_view isa) {
        for (const bool any : {false, true}) {
          HitBatch hits(rays.size);
          KernelScratch scratch;
          EXPECT_TRUE(scratch.choice(any).together());
          any ? core.occluded(rays, hits, scratch) : core.closest(rays, hits, scratch);
          EXPECT_FALSE(scratch.choice(any).together()) << isa;
        }
      });
}

}  // namespace
}  // namespace raysweep
