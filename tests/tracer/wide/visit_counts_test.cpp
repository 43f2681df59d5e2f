// Visits are counted one by one: where they are known by hand, and where two ways of counting must agree.
#include "tracer/wide/visit_counts.h"

#include <gtest/gtest.h>

#include "tests/tracer/scene_sizes.h"
#include "tests/tracer/triangle_row.h"
#include "tests/tracer/wide/batches.h"

namespace raysweep {
namespace {

static_assert(counts_visits, "these tests are built only where visits are counted");

/// As many rays as a packet takes, next to each other, down the row; `x`: where they pass.
std::vector<TestRay<float>> rays_down_the_row(float x) {
  std::vector<TestRay<float>> rays;
  for (size_t i = 0; i < packet_size; ++i) {
    const float aside = 0.001f * static_cast<float>(i);
    rays.push_back({{{x + aside, -0.5f, 3}, {0.001f, 0.002f, -1}}, std::numeric_limits<float>::infinity()});
  }
  return rays;
}

struct Counted {
  VisitCounts visits;
  size_t groups_alone;
};

template <class Core>
Counted trace(const Core& core, const std::vector<TestRay<float>>& tests, Grouping grouping) {
  const RayBatch rays = batch_of(tests);
  HitBatch hits(tests.size());
  KernelScratch scratch;
  core.closest(rays, hits, scratch, grouping);
  return {scratch.visits, scratch.groups.size()};
}

VisitCounts counts(std::initializer_list<std::pair<Visited, uint64_t>> list) {
  VisitCounts all;
  for (const auto& [what, count] : list) all[what] = count;
  return all;
}

TEST(visit_counts, of_rays_alone_are_what_they_meet) {
  for_each_wide_core<MollerTrumbore>(
      triangles_in_a_row(1), "sah", 4, [](const auto& core, std::string_view isa) {
        EXPECT_EQ(trace(core, rays_down_the_row(-0.5f), Grouping::single).visits,
                  counts({{Visited::ray_begun, 16},
                          {Visited::ray_node, 16},
                          {Visited::ray_block, 16},
                          {Visited::ray_test, 16},
                          {Visited::ray_look, 16}}))
            << isa;
        EXPECT_EQ(trace(core, rays_down_the_row(5), Grouping::single).visits, VisitCounts()) << isa;
      });
}

TEST(visit_counts, of_flat_rays_are_those_of_all_others) {
  std::vector<TestRay<float>> rays = rays_down_the_row(-0.5f);
  for (const size_t flat : {0, 3, 9}) rays[flat].ray.direction = {0, 0, -1};
  for_each_wide_core<MollerTrumbore>(
      triangles_in_a_row(1), "sah", 4, [&](const auto& core, std::string_view isa) {
        for (const Grouping grouping : {Grouping::single, Grouping::packets})
          EXPECT_EQ(trace(core, rays, grouping).visits[Visited::ray_look], 16u) << isa;
        EXPECT_EQ(trace(core, rays, Grouping::single).visits,
                  trace(core, rays_down_the_row(-0.5f), Grouping::single).visits)
            << isa;
      });
}

TEST(visit_counts, of_a_packet_are_those_of_one_ray) {
  for_each_wide_core<MollerTrumbore>(
      triangles_in_a_row(1), "sah", 4, [](const auto& core, std::string_view isa) {
        EXPECT_EQ(trace(core, rays_down_the_row(-0.5f), Grouping::packets).visits,
                  counts({{Visited::packet_begun, 1},
                          {Visited::packet_node, 1},
                          {Visited::packet_box, 1},
                          {Visited::packet_block, 1},
                          {Visited::packet_test, 1},
                          {Visited::packet_look, 1}}))
            << isa;
        EXPECT_EQ(trace(core, rays_down_the_row(5), Grouping::packets).visits,
                  counts({{Visited::packet_missed, 1}}))
            << isa;
      });
}

/// Rays of one packet that part: one meets the triangle, the others pass by.
TEST(visit_counts, of_a_packet_whose_rays_part_are_those_of_the_rays_that_meet_something) {
  std::vector<TestRay<float>> rays = rays_down_the_row(-0.5f);
  for (size_t i = 1; i < packet_size; ++i) rays[i].ray.origin.x += 3;
  for_each_wide_core<MollerTrumbore>(
      triangles_in_a_row(1), "sah", 4, [&](const auto& core, std::string_view isa) {
        EXPECT_EQ(trace(core, rays, Grouping::packets).visits, counts({{Visited::packet_begun, 1},
                                                                       {Visited::packet_node, 1},
                                                                       {Visited::packet_box, 1},
                                                                       {Visited::packet_block_apart, 1},
                                                                       {Visited::packet_ray, 1},
                                                                       {Visited::packet_ray_look, 1}}))
            << isa;
      });
}

TEST(visit_counts, without_a_hierarchy_every_triangle_is_tested) {
  constexpr uint64_t triangles = 20;
  for_each_wide_core<MollerTrumbore>(
      triangles_in_a_row(triangles), "none", 1, [&](const auto& core, std::string_view isa) {
        const VisitCounts visits = trace(core, rays_down_the_row(-0.5f), Grouping::single).visits;
        EXPECT_EQ(visits[Visited::ray_node], 16u) << isa;
        EXPECT_EQ(visits[Visited::ray_block], 16 * (isa.starts_with("avx") ? 3u : 5u)) << isa;
        EXPECT_EQ(visits[Visited::ray_test], 16 * triangles) << isa;
      });
}

TEST(visit_counts, every_group_goes_together_or_alone) {
  const Scene scene = scenes_up_to(brute_force_triangles).front().make(2);
  const ScalarCore<float, MollerTrumbore> oracle(scene, "sah", 4);
  std::vector<TestRay<float>> tests = make_rays<float>(scene, oracle, "primary", 1600, PixelOrder::blocks);
  for (const char* kind : {"primary", "reflected", "random"})
    for (const auto& test : make_rays<float>(scene, oracle, kind, 1600)) tests.push_back(test);
  tests.push_back(tests.front());
  for_each_wide_core<MollerTrumbore>(scene, "sah", 4, [&](const auto& core, std::string_view isa) {
    const auto [visits, groups_alone] = trace(core, tests, Grouping::packets);
    EXPECT_GT(visits[Visited::packet_refused], 0u) << isa;
    EXPECT_GT(visits[Visited::packet_node_of_few], 0u) << isa;
    EXPECT_EQ(
        visits[Visited::packet_begun] + visits[Visited::packet_missed] + visits[Visited::packet_refused],
        tests.size() / packet_size)
        << isa;
    EXPECT_EQ(visits[Visited::packet_refused] + 1, groups_alone)
        << isa << ": the last ray is a group of its own";
    EXPECT_LE(visits[Visited::ray_begun], groups_alone * packet_size) << isa;
  });
}

}  // namespace
}  // namespace raysweep
