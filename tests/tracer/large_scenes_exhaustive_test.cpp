// Scenes that brute force cannot take as a whole: two hierarchies agree on a million rays of each kind, and
// both with brute force on some of them. All that is to be said of the million triangles of `planet` is here:
// in the quick tests they would take seconds, with sanitizers a minute.
#include "tests/tracer/rock_scenes.h"
#include "tests/tracer/scene_sizes.h"
#include "tests/tracer/wide/batches.h"
#include "tracer/scene/pebble.h"

namespace raysweep {
namespace {

class LargeScenes : public testing::TestWithParam<std::tuple<std::string, std::string>> {};

std::vector<std::string> large_scene_names() {
  std::vector<std::string> names;
  for (const BuiltInScene& scene : large_scenes()) names.emplace_back(scene.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(hits, LargeScenes,
                         testing::Combine(testing::ValuesIn(large_scene_names()),
                                          testing::Values("primary", "shadow", "reflected")),
                         [](const auto& info) {
                           return std::get<0>(info.param) + "_" + std::get<1>(info.param);
                         });

TEST_P(LargeScenes, hierarchies_agree_on_a_million_rays) {
  const auto& [name, kind] = GetParam();
  expect_agreeing_hierarchies<float>(load_scene(name, 2), {kind}, 1'000'000);
}

TEST_P(LargeScenes, the_wide_core_agrees_on_a_million_rays_on_every_instruction_set) {
  const auto& [name, kind] = GetParam();
  const Scene scene = load_scene(name, 2);
  const ScalarCore<float, MollerTrumbore> scalar(scene, "sah", 4);
  for (const PixelOrder order : {PixelOrder::scattered, PixelOrder::blocks}) {
    const auto rays = make_rays<float>(scene, scalar, kind, 1'000'000, order);
    const Answers expected(scalar, rays);
    for_each_wide_core<MollerTrumbore>(scene, "sah", 4, [&](const auto& core, std::string_view isa) {
      EXPECT_EQ(count_differences(core, expected, rays), 0u) << isa;
    });
  }
}

TEST_P(LargeScenes, brute_force_agrees_on_300_rays) {
  const auto& [name, kind] = GetParam();
  const Scene scene = load_scene(name, 2);
  using Core = ScalarCore<float, MollerTrumbore>;
  const Core oracle(scene, "none", 1), sah(scene, "sah", 4);
  for (const auto& ray : make_rays<float>(scene, sah, kind, 300))
    ASSERT_TRUE(answers_agree(oracle, sah, ray));
}

TEST(large_scenes, have_as_many_shapes_as_the_list_tells) {
  for (const BuiltInScene& built_in : large_scenes())
    EXPECT_TRUE(has_what_is_told(built_in.make(1), built_in)) << built_in.name;
}

TEST(planet, closes_and_has_1003520_triangles) {
  const Scene scene = make_planet(3);
  EXPECT_EQ(scene.name, "planet");
  EXPECT_EQ(scene.lights.size(), 3u);
  ASSERT_EQ(scene.meshes.size(), 1u);
  EXPECT_EQ(scene.triangle_count(), 1'003'520u);
  EXPECT_EQ(scene.meshes[0].vertices.size(), 1'003'520u / 2 + 2) << "Euler: no vertex is there twice";
  EXPECT_TRUE(is_closed(scene.meshes[0]));
  expect_every_triangle_faces_outwards(scene.meshes[0]);
}

TEST(planet, is_the_same_bit_for_bit_on_every_machine) {
  EXPECT_EQ(mesh_hash(make_planet(1).meshes[0]), "f81a3e4aae783c9d66356d6e664c3179");
}

TEST(planet, is_opaque_mirroring_triangles_alone) { expect_opaque_mirroring_triangles_alone(make_planet(2)); }

TEST(planet, fills_the_picture_and_mirrors_itself) {
  expect_a_full_picture_that_mirrors_itself(make_planet(2));
}

}  // namespace
}  // namespace raysweep
