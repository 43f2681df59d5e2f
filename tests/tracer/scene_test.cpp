#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>

#include "tests/tracer/scene_sizes.h"
#include "tracer/scene/chair.h"
#include "tracer/scene/view.h"

namespace raysweep {
namespace {

/// How often each undirected edge of a mesh is used.
std::map<std::pair<uint32_t, uint32_t>, int> edge_uses(const Mesh& mesh) {
  std::map<std::pair<uint32_t, uint32_t>, int> uses;
  for (const auto& t : mesh.triangles) {
    for (size_t i = 0; i < 3; ++i) uses[std::minmax(t[i], t[(i + 1) % 3])]++;
  }
  return uses;
}

TEST(chair, has_exactly_10817_triangles) {
  const Chair chair = make_chair();
  EXPECT_EQ(chair.frame.triangles.size() + chair.seat.triangles.size(), chair_triangle_count);
  EXPECT_EQ(chair_triangle_count, 10817u);
  EXPECT_EQ(load_scene("chair-ball", 1).triangle_count(), chair_triangle_count)
      << "the ball is one primitive";
}

TEST(chair, the_frame_is_closed_and_the_seat_is_one_open_sheet) {
  const Chair chair = make_chair();
  for (const auto& [edge, uses] : edge_uses(chair.frame)) ASSERT_EQ(uses, 2);
  int border = 0;
  for (const auto& [edge, uses] : edge_uses(chair.seat)) {
    ASSERT_LE(uses, 2);
    border += uses == 1;
  }
  EXPECT_EQ(border, 4 * 40 - 1) << "four sides of 40 edges, with the corner cut";
  EXPECT_EQ(chair.seat.triangles.size() % 2, 1u);
}

TEST(chair, has_no_degenerate_triangle) {
  const Chair chair = make_chair();
  for (const Mesh* mesh : {&chair.frame, &chair.seat}) {
    for (const auto& [a, b, c] : mesh->triangles) {
      const Vec3d u = Vec3d(mesh->vertices[b]) - Vec3d(mesh->vertices[a]),
                  v = Vec3d(mesh->vertices[c]) - Vec3d(mesh->vertices[a]);
      ASSERT_GT(length(cross(u, v)), 1e-8) << mesh->name;
    }
  }
}

TEST(chair_ball, both_shapes_are_ideal_mirrors_with_a_colour_of_their_own) {
  for (const Material& m : load_scene("chair-ball", 1).materials) {
    EXPECT_EQ(m.k_reflect, 1);
    EXPECT_GT(m.k_ambient, 0);
    EXPECT_GT(m.k_diffuse, 0);
    EXPECT_GT(m.k_specular, 0);
  }
}

TEST(scenes, every_index_and_every_vertex_is_good) {
  for (const BuiltInScene& built_in : scenes_up_to(quick_triangles)) {
    const Scene scene = built_in.make(3);
    EXPECT_EQ(scene.name, built_in.name);
    EXPECT_TRUE(has_what_is_told(scene, built_in)) << scene.name;
    EXPECT_EQ(scene.lights.size(), 3u);
    for (const Mesh& mesh : scene.meshes) {
      EXPECT_LT(mesh.material, scene.materials.size());
      for (const Vec3f& v : mesh.vertices) ASSERT_TRUE(all_finite(v));
      for (const auto& t : mesh.triangles) {
        for (const uint32_t i : t) ASSERT_LT(i, mesh.vertices.size());
      }
    }
    for (const Sphere& s : scene.spheres) EXPECT_LT(s.material, scene.materials.size());
  }
}

TEST(light_dome, keeps_the_exposure_whatever_the_count) {
  for (const int count : {1, 2, 3, 18, 64}) {
    double sum = 0;
    for (const Light& light : light_dome(count, {1, 2, 3}, 5)) {
      sum += light.intensity.x;
      EXPECT_NEAR(length(light.position - Vec3d(1, 2, 3)), 5, 1e-9);
      EXPECT_GT(light.position.y, 2) << "lights shine from above";
    }
    EXPECT_NEAR(sum, 1, 1e-12);
  }
  EXPECT_TRUE(light_dome(0, {}, 1).empty());
}

TEST(view, x_grows_rightwards_and_y_downwards) {
  const Camera camera{.position = {0, 0, 5}, .target = {0, 0, 0}, .half_angle = 0.5};
  const View<double> view(camera, 200, 100);
  const auto middle = view.through(100, 50).direction;
  EXPECT_NEAR(middle.x, 0, 1e-12);
  EXPECT_NEAR(middle.z, -1, 1e-12);
  EXPECT_GT(view.through(199, 50).direction.x, 0);
  EXPECT_LT(view.through(100, 99).direction.y, 0);
  const auto top = view.through(100, 0).direction;
  EXPECT_NEAR(std::atan2(top.y, -top.z), 0.5, 1e-12) << "half the vertical field of view";
}

TEST(frame_meshes, every_vertex_of_a_framed_mesh_is_in_the_picture) {
  for (const double scale : {1e-6, 1.0, 1e6}) {
    Mesh mesh;
    for (const double x : {-3.0, 1.0}) {
      for (const double y : {0.0, 5.0}) {
        for (const double z : {2.0, 9.0}) mesh.vertices.emplace_back(Vec3d(x, y, z) * scale);
      }
    }
    mesh.triangles = {{0, 1, 2}};
    const Scene scene = frame_meshes("box", {{mesh}, {plain_surface()}}, 1);
    const Camera& c = scene.camera;
    const Vec3d forward = normalize(c.target - c.position), right = normalize(cross(forward, c.up)),
                up = cross(right, forward);
    double widest = 0;
    for (const Vec3f& v : scene.meshes[0].vertices) {
      const Vec3d to = Vec3d(v) - c.position;
      const double depth = dot(to, forward), limit = std::tan(c.half_angle);
      ASSERT_GT(depth, 0);
      widest = std::max({widest, std::abs(dot(to, up)) / depth / limit,
                         std::abs(dot(to, right)) / depth / (limit * 4 / 3)});
    }
    EXPECT_LT(widest, 1) << "outside";
    EXPECT_GT(widest, 0.5) << "lost in the middle";
  }
}

TEST(frame_meshes, a_mesh_far_out_is_moved_to_the_origin) {
  Mesh mesh;
  mesh.vertices = {{1e6f, 0, 0}, {1e6f + 2, 0, 0}, {1e6f, 2, 2}};
  mesh.triangles = {{0, 1, 2}};
  const Scene scene = frame_meshes("far", {{mesh}, {plain_surface()}}, 1);
  EXPECT_EQ(scene.meshes[0].vertices[0], Vec3f(-1, -1, -1));
  EXPECT_EQ(scene.meshes[0].vertices[1], Vec3f(1, -1, -1));
  EXPECT_LT(length(scene.camera.position), 20);
}

TEST(load_scene, as_many_lights_as_asked_for_else_its_own) {
  for (const BuiltInScene& built_in : scenes_up_to(quick_triangles)) {
    const std::string name(built_in.name);
    EXPECT_EQ(load_scene(name).lights.size(), static_cast<size_t>(own_light_count(name)));
    EXPECT_EQ(load_scene(name, 5).lights.size(), 5u);
    EXPECT_TRUE(load_scene(name, 0).lights.empty());
  }
  const std::string file = RAYSWEEP_SOURCE_DIR "/experiments/scenes/glass-ball.toml";
  const int count = own_light_count(file);
  EXPECT_EQ(load_scene(file).lights.size(), static_cast<size_t>(count));
  EXPECT_EQ(load_scene(file, 1).lights.size(), 1u);
  try {
    (void)load_scene(file, count + 1);
    FAIL();
  } catch (const SceneError& error) {
    EXPECT_EQ(error.what(),
              fmt::format("{0}: has {1} lights, {2} were asked for; ask for at most {1} or add lights "
                          "to it",
                          file, count, count + 1));
  }
}

TEST(load_scene, an_unknown_scene_is_told_with_the_known_ones) {
  try {
    (void)load_scene("chair-bell", 1);
    FAIL();
  } catch (const SceneError& error) {
    std::string names;
    for (const BuiltInScene& scene : built_in_scenes())
      names += (names.empty() ? "" : ", ") + std::string(scene.name);
    EXPECT_EQ(error.what(), "no scene \"chair-bell\": it is neither built in (those are: " + names +
                                ") nor a scene or mesh file that can be opened");
  }
}

}  // namespace
}  // namespace raysweep
