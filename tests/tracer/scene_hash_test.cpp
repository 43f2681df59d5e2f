#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "tests/tracer/scene_sizes.h"

namespace raysweep {
namespace {

TEST(scene_hash, is_the_same_for_the_same_scene_and_differs_between_scenes) {
  std::set<std::string> hashes;
  for (const BuiltInScene& built_in : scenes_up_to(quick_triangles)) {
    const std::string hash = scene_hash(built_in.make(built_in.light_count));
    EXPECT_EQ(scene_hash(built_in.make(built_in.light_count)), hash);
    EXPECT_TRUE(hashes.insert(hash).second) << built_in.name;
  }
  EXPECT_NE(scene_hash(load_scene("studio", 1)), scene_hash(load_scene("studio", 2))) << "lights";
}

TEST(scene_hash, everything_that_a_picture_depends_on_changes_it) {
  const Scene scene = load_scene("ice");
  ASSERT_FALSE(scene.meshes.empty());
  const std::function<void(Scene&)> changes[] = {
      [](Scene& s) { s.camera.half_angle += 0.01; },
      [](Scene& s) { s.camera.up.x += 0.01; },
      [](Scene& s) { s.background.z += 0.5; },
      [](Scene& s) { s.ambient.y *= 0.5; },
      [](Scene& s) { s.lights.front().position.y += 1; },
      [](Scene& s) { s.materials.front().ior += 0.1; },
      [](Scene& s) { s.materials.front().fresnel = !s.materials.front().fresnel; },
      [](Scene& s) { s.materials.front().priority += 1; },
      [](Scene& s) { s.meshes.front().vertices.back().z += 0.01f; },
      [](Scene& s) { std::swap(s.meshes.front().triangles.front(), s.meshes.front().triangles.back()); },
      [](Scene& s) { s.meshes.front().material += 1; },
      [](Scene& s) {
        s.spheres.push_back({{0, 0, 0}, 1, 0});
      },
      [](Scene& s) {
        s.planes.push_back({{0, 1, 0}, 1, 0});
      }};
  std::set<std::string> hashes{scene_hash(scene)};
  for (const auto& change : changes) {
    Scene other = scene;
    change(other);
    EXPECT_TRUE(hashes.insert(scene_hash(other)).second) << "change " << hashes.size();
  }
  Scene renamed = scene;
  renamed.name = "other";
  EXPECT_EQ(scene_hash(renamed), scene_hash(scene)) << "a name shows in no picture";
}

}  // namespace
}  // namespace raysweep
