// Brute force, both hierarchies and the wide core on every instruction set give the same hits on a million
// rays of each kind on each scene; the two that show the same chair, of 10,817 triangles, share a million.
// Scenes of more triangles have a file of their own.
#include <gtest/gtest.h>

#include "tests/tracer/brute_force.h"
#include "tests/tracer/variants.h"
#include "tests/tracer/wide/batches.h"
#include "tracer/intersect/all.h"
#include "tracer/scene/scenes.h"

namespace raysweep {
namespace {

constexpr size_t ray_count = 1'000'000;

/// Brute force takes 30 µs a ray on the chair, by four at a time.
size_t rays_of(const std::string& scene) {
  return scene == "chair-ball" || scene == "studio" ? ray_count / 2 : ray_count;
}

class Exhaustive : public testing::TestWithParam<std::tuple<std::string, std::string>> {};
INSTANTIATE_TEST_SUITE_P(hits, Exhaustive,
                         testing::Combine(testing::ValuesIn(scene_names()),
                                          testing::Values("primary", "shadow", "reflected")),
                         [](const auto& info) {
                           std::string name = std::get<0>(info.param) + "_" + std::get<1>(info.param);
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST_P(Exhaustive, a_million_rays_agree) {
  const auto& [name, kind] = GetParam();
  const Scene scene = load_scene(name, 2);
  using Core = ScalarCore<float, MollerTrumbore>;
  const Core median(scene, "median", 4), sah(scene, "sah", 4);
  const auto rays = make_rays<float>(scene, sah, kind, rays_of(name));
  size_t differences = 0;
  for (std::span<const TestRay<float>> rest = rays; !rest.empty();) {
    const auto group = rest.first(std::min(lane_count, rest.size()));
    rest = rest.subspan(group.size());
    const auto nearest = nearest_of_all(sah.primitives(), group);
    for (size_t i = 0; i < group.size(); ++i) {
      differences += !is_answer(sah, group[i], nearest[i]);
      differences += !is_answer(median, group[i], nearest[i]);
    }
  }
  EXPECT_EQ(differences, 0u);
  const auto neighbours = make_rays<float>(scene, sah, kind, rays_of(name), PixelOrder::blocks);
  const Answers expected(sah, rays), expected_of_neighbours(sah, neighbours);
  for_each_wide_core<MollerTrumbore>(scene, "sah", 4, [&](const auto& core, std::string_view isa) {
    EXPECT_EQ(count_differences(core, expected, rays), 0u) << isa;
    EXPECT_EQ(count_differences(core, expected_of_neighbours, neighbours), 0u) << isa;
  });
}

}  // namespace
}  // namespace raysweep
