#include "tracer/scene/pebble.h"

#include "tests/tracer/rock_scenes.h"

namespace raysweep {
namespace {

TEST(pebble, closes_and_has_69620_triangles) {
  const Scene scene = make_pebble(2);
  ASSERT_EQ(scene.meshes.size(), 1u);
  EXPECT_EQ(scene.triangle_count(), 69620u);
  EXPECT_EQ(scene.meshes[0].vertices.size(), 69620u / 2 + 2) << "Euler: no vertex is there twice";
  EXPECT_TRUE(is_closed(scene.meshes[0]));
  expect_every_triangle_faces_outwards(scene.meshes[0]);
}

TEST(pebble, is_the_same_bit_for_bit_on_every_machine) {
  EXPECT_EQ(mesh_hash(make_pebble(1).meshes[0]), "beba3b248b0db37853b723497654086a");
}

TEST(pebble, is_opaque_mirroring_triangles_alone) { expect_opaque_mirroring_triangles_alone(make_pebble(2)); }

TEST(pebble, fills_the_picture_and_mirrors_itself) {
  expect_a_full_picture_that_mirrors_itself(make_pebble(2));
}

TEST(pebble, hierarchies_agree_in_every_hit_in_both_precisions) {
  const Scene scene = make_pebble(2);
  expect_agreeing_hierarchies<float>(scene, {"primary", "shadow", "reflected", "random"}, 2000);
  expect_agreeing_hierarchies<double>(scene, {"primary", "shadow", "reflected", "random"}, 500);
}

}  // namespace
}  // namespace raysweep
