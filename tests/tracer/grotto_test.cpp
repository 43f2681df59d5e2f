#include "tracer/scene/grotto.h"

#include "tests/tracer/rock_scenes.h"

namespace raysweep {
namespace {

TEST(grotto, both_meshes_close_and_have_200012_triangles) {
  const Scene scene = make_grotto(2);
  ASSERT_EQ(scene.meshes.size(), 2u);
  EXPECT_EQ(scene.triangle_count(), 200'012u);
  for (const Mesh& mesh : scene.meshes) EXPECT_TRUE(is_closed(mesh)) << mesh.name;
  expect_every_triangle_faces_outwards(scene.meshes[1]);
}

TEST(grotto, the_rock_is_the_same_bit_for_bit_on_every_machine) {
  EXPECT_EQ(mesh_hash(make_grotto(1).meshes[1]), "c3bae2bb042e448db10faaa0a9ce839e");
}

TEST(grotto, is_opaque_mirroring_triangles_alone) { expect_opaque_mirroring_triangles_alone(make_grotto(2)); }

TEST(grotto, the_rock_is_in_the_room_and_so_are_camera_and_lights_outside_of_the_rock) {
  const Scene scene = make_grotto(18);
  const Mesh &room = scene.meshes[0], &rock = scene.meshes[1];
  for (const Vec3f& vertex : rock.vertices) {
    const Vec3d v(vertex);
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_GT(v[axis], bounds_of(room).lower()[axis]);
      ASSERT_LT(v[axis], bounds_of(room).upper()[axis]);
    }
  }
  std::vector<Vec3d> points{scene.camera.position};
  for (const Light& light : scene.lights) points.push_back(light.position);
  for (const Vec3d& point : points) {
    EXPECT_TRUE(contains(room, point));
    EXPECT_FALSE(contains(rock, point));
  }
}

TEST(grotto, every_ray_from_inside_hits_and_so_do_its_reflections) {
  const Scene scene = make_grotto(2);
  const ScalarCore<float, MollerTrumbore> core(scene, "sah", 4);
  for (const char* kind : {"primary", "reflected", "random"})
    EXPECT_EQ(hitting_share(scene, core, kind, 5000), 1) << kind;
}

TEST(grotto, hierarchies_agree_in_every_hit) {
  expect_agreeing_hierarchies<float>(make_grotto(2), {"primary", "shadow", "reflected"}, 1000);
}

}  // namespace
}  // namespace raysweep
