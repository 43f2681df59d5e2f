#include "tracer/wide/group_choice.h"

#include <gtest/gtest.h>

#include "tests/tracer/scene_sizes.h"
#include "tests/tracer/triangle_row.h"
#include "tests/tracer/wide/batches.h"

namespace raysweep {
namespace {

/// Of groups whose rays take `cycles` alone.
GroupChoice alone_for(uint64_t cycles) {
  GroupChoice choice;
  choice.went_alone(cycles * 100, 100 * packet_size);
  return choice;
}

/// How many of `count` groups go together where every other one takes more cycles than the rest.
int together(GroupChoice& choice, int count, uint32_t cycles, uint32_t cycles_of_every_other) {
  int tried = 0;
  for (int i = 0; i < count; ++i)
    if (choice.together()) choice.went_together(++tried % 2 == 0 ? cycles_of_every_other : cycles);
  return tried;
}
int together(GroupChoice&& choice, int count, uint32_t cycles, uint32_t cycles_of_every_other) {
  return together(choice, count, cycles, cycles_of_every_other);
}

TEST(group_choice, goes_together_as_long_as_that_pays) {
  EXPECT_EQ(together(alone_for(3000), 1000, 1000, 4500), 1000);
  EXPECT_EQ(together(GroupChoice(), 1000, 1000, 4500), 1000);  // nothing is known of single rays yet
}

TEST(group_choice, goes_alone_where_it_does_not) {
  const int tried = together(alone_for(3000), 10000, 4000, 5000);
  EXPECT_GT(tried, 100);  // tries again from time to time
  EXPECT_LT(tried, 600);
}

TEST(group_choice, asks_what_rays_take_alone) {
  EXPECT_EQ(together(alone_for(5000), 1000, 1000, 4500), 1000);
  EXPECT_LT(together(alone_for(2000), 1000, 1000, 4500), 300);
}

TEST(group_choice, follows_what_rays_take_alone_later) {
  GroupChoice choice = alone_for(5000);
  for (int i = 0; i < 1000; ++i) choice.went_alone(2000 * 100, 100 * packet_size);
  EXPECT_LT(together(choice, 1000, 1000, 4500), 300);
}

TEST(group_choice, less_than_a_group_alone_tells_nothing_yet) {
  GroupChoice choice;
  choice.went_alone(1, packet_size - 1);
  EXPECT_EQ(together(choice, 1000, 1000, 4500), 1000);
}

TEST(group_choice, explores_a_few_groups_once) {
  GroupChoice choice;
  const auto explored = [&choice](int count) {
    int found = 0;
    for (int i = 0; i < count; ++i) found += choice.explores() ? 1 : 0;
    return found;
  };
  EXPECT_EQ(explored(32), 0);
  EXPECT_EQ(explored(64), 8);
  EXPECT_EQ(explored(100000), 0);
}

TEST(group_choice, kinds_of_rays_have_one_each) {
  KernelScratch scratch;
  scratch.begin_level(3);
  scratch.choice(false).went_together(1 << 20);
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
      KernelScratch trusting, doubting, averse;
      const size_t first = groups_alone(trusting), later = groups_alone(trusting);
      EXPECT_EQ(first, later + 8) << isa << ": explores";
      EXPECT_LT(first, count / packet_size / 2) << isa;
      doubting.choice(any).went_together(1 << 20);
      EXPECT_GE(groups_alone(doubting), later + 30) << isa << ": thirty-one go alone, then packets do well";
      averse.choice(any).went_alone(1, 60000);
      for (int i = 0; i < 99; ++i) averse.choice(any).went_together(1000);
      EXPECT_GT(groups_alone(averse), first + 30) << isa << ": packets take longer than that";
    }
  });
}

/// Without a hierarchy nothing is saved by going together.
TEST(group_choice, is_told_what_packets_take) {
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
