#include "tracer/scene/scene_file.h"

#include <algorithm>
#include <numbers>

#include "tests/tracer/scene_folder.h"
#include "tracer/scene/chair.h"

namespace raysweep {
namespace {

using SceneFileReads = SceneFolder;

TEST_F(SceneFileReads, what_stands_at_the_top) {
  const Scene scene =
      load("title = 'A ball'\nbackground = [0.1, 0.2, 0.3]\nambient = [1, 2, 3]\n" + material + sphere);
  EXPECT_EQ(scene.name, "A ball");
  EXPECT_EQ(scene.background, Colour(0.1, 0.2, 0.3));
  EXPECT_EQ(scene.ambient, Colour(1, 2, 3));
}

TEST_F(SceneFileReads, dots_in_comments_and_titles_are_no_keys) {
  std::string dots;
  for (int i = 0; i < 40; ++i) dots += "0.1, ";
  EXPECT_EQ(load("# don't: " + dots + "\ntitle = '" + dots + "'\n" + material + sphere).name, dots);
}

TEST_F(SceneFileReads, defaults_at_the_top) {
  const Scene scene = load(material + sphere);
  EXPECT_EQ(scene.name, (folder / "scene.toml").string());
  EXPECT_EQ(scene.background, Colour(0, 0, 0));
  EXPECT_EQ(scene.ambient, Colour(1, 1, 1));
  EXPECT_TRUE(scene.lights.empty());
}

TEST_F(SceneFileReads, the_camera) {
  const Scene scene =
      load("[camera]\nposition = [0, 1, 4]\ntarget = [0, 1, 0]\nup = [0, 3, 4]\nfield_of_view = 60\n" +
           material + sphere);
  EXPECT_EQ(scene.camera.position, Vec3d(0, 1, 4));
  EXPECT_EQ(scene.camera.target, Vec3d(0, 1, 0));
  EXPECT_NEAR(length(scene.camera.up - Vec3d(0, 0.6, 0.8)), 0, 1e-15);
  EXPECT_NEAR(scene.camera.half_angle, std::numbers::pi / 6, 1e-15);
}

TEST_F(SceneFileReads, the_camera_with_defaults) {
  const Camera camera =
      load("[camera]\nposition = [0, 1, 4]\ntarget = [0, 1, 0]\n" + material + sphere).camera;
  EXPECT_EQ(camera.up, Vec3d(0, 1, 0));
  EXPECT_NEAR(camera.half_angle, 20 * std::numbers::pi / 180, 1e-15);
}

TEST_F(SceneFileReads, without_a_camera_all_that_has_an_end_is_framed) {
  const Scene scene = load(material + sphere +
                           "[[objects]]\nshape = 'plane'\nnormal = [0, 1, 0]\npoint = [0, -1, 0]\n"
                           "material = 'm'\n[[objects]]\nshape = 'box'\nlower = [9, -1, -1]\n"
                           "upper = [11, 1, 1]\nmaterial = 'm'\n");
  EXPECT_EQ(scene.camera.target, Vec3d(5, 0, 0));
  const double radius = std::sqrt(36 + 1 + 1);
  EXPECT_NEAR(length(scene.camera.position - scene.camera.target),
              1.05 * radius / std::sin(scene.camera.half_angle), 1e-9);
}

TEST_F(SceneFileReads, every_key_of_a_material) {
  const Material m = load(
                         "[materials.m]\nambient = [0.1, 0.2, 0.3]\ndiffuse = [0.4, 0.5, 0.6]\n"
                         "specular = [0.7, 0.8, 0.9]\nk_ambient = 0.11\nk_diffuse = 0.12\nk_specular = 0.13\n"
                         "exponent = 14\nk_reflect = 0.15\nk_refract = 0.16\nfilter = [0.9, 1, 0.8]\n"
                         "ior = 1.33\nfresnel = true\npriority = -3\n" +
                         sphere)
                         .materials.at(0);
  EXPECT_EQ(m.ambient, Colour(0.1, 0.2, 0.3));
  EXPECT_EQ(m.diffuse, Colour(0.4, 0.5, 0.6));
  EXPECT_EQ(m.specular, Colour(0.7, 0.8, 0.9));
  EXPECT_EQ(m.k_ambient, 0.11);
  EXPECT_EQ(m.k_diffuse, 0.12);
  EXPECT_EQ(m.k_specular, 0.13);
  EXPECT_EQ(m.exponent, 14);
  EXPECT_EQ(m.k_reflect, 0.15);
  EXPECT_EQ(m.k_refract, 0.16);
  EXPECT_EQ(m.filter, Colour(0.9, 1, 0.8));
  EXPECT_EQ(m.ior, 1.33);
  EXPECT_TRUE(m.fresnel);
  EXPECT_EQ(m.priority, -3);
}

TEST_F(SceneFileReads, colour_sets_ambient_and_diffuse_unless_they_are_given) {
  const Scene scene = load(
      "[materials.a]\ncolour = [1, 0, 0]\n[materials.m]\ndiffuse = [0, 1, 0]\n"
      "colour = [1, 0, 0]\n" +
      sphere);
  EXPECT_EQ(scene.materials.at(0).ambient, Colour(1, 0, 0));
  EXPECT_EQ(scene.materials.at(0).diffuse, Colour(1, 0, 0));
  EXPECT_EQ(scene.materials.at(0).specular, Colour(1, 1, 1));
  EXPECT_EQ(scene.materials.at(1).ambient, Colour(1, 0, 0));
  EXPECT_EQ(scene.materials.at(1).diffuse, Colour(0, 1, 0));
  EXPECT_EQ(scene.spheres.at(0).material, 1u);
}

TEST_F(SceneFileReads, spheres_and_planes) {
  const Scene scene = load("[materials.a]\n" + material +
                           "[[objects]]\nshape = 'sphere'\ncentre = [1, 2, 3]\nradius = 4.5\nmaterial = 'm'\n"
                           "[[objects]]\nshape = 'plane'\nnormal = [0, 0, 1e-200]\npoint = [7, 8, 9]\n"
                           "material = 'm'\n");
  EXPECT_EQ(scene.spheres.at(0).centre, Vec3d(1, 2, 3));
  EXPECT_EQ(scene.spheres.at(0).radius, 4.5);
  EXPECT_EQ(scene.spheres.at(0).material, 1u);
  EXPECT_EQ(scene.planes.at(0).normal, Vec3d(0, 0, 1));
  EXPECT_EQ(scene.planes.at(0).offset, -9);
  EXPECT_EQ(scene.planes.at(0).material, 1u);
}

TEST_F(SceneFileReads, boxes_turned_about_their_own_centre) {
  const Scene scene =
      load(material +
           "[[objects]]\nshape = 'box'\nlower = [1, 1, 1]\nupper = [3, 2, 2]\nmaterial = 'm'\n"
           "[[objects]]\nshape = 'box'\nlower = [1, 1, 1]\nupper = [3, 2, 2]\nmaterial = 'm'\n"
           "rotate = [0, 0, 90]\n");
  EXPECT_EQ(bounds_of(scene.meshes.at(0)).lower(), Vec3d(1, 1, 1));
  EXPECT_EQ(bounds_of(scene.meshes.at(0)).upper(), Vec3d(3, 2, 2));
  const Box<double> turned = bounds_of(scene.meshes.at(1));
  EXPECT_NEAR(length(turned.lower() - Vec3d(1.5, 0.5, 1)), 0, 1e-6);
  EXPECT_NEAR(length(turned.upper() - Vec3d(2.5, 2.5, 2)), 0, 1e-6);
}

TEST_F(SceneFileReads, triangles) {
  const Scene scene =
      load("[materials.a]\n" + material +
           "[[objects]]\nshape = 'triangles'\nvertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0.5]]\n"
           "triangles = [[0, 1, 2], [2, 1, 0]]\nmaterial = 'm'\n");
  const Mesh& mesh = scene.meshes.at(0);
  EXPECT_EQ(mesh.vertices.at(2), Vec3f(0, 1, 0.5));
  EXPECT_EQ(mesh.triangles.at(1), (std::array<uint32_t, 3>{2, 1, 0}));
  EXPECT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.material, 1u);
}

TEST_F(SceneFileReads, the_chair_placed_with_a_seat_of_its_own_material) {
  const Scene scene = load("[materials.a]\n" + material +
                           "[[objects]]\nshape = 'chair'\nmaterial = 'm'\nseat_material = 'a'\nscale = 2\n"
                           "translate = [0, 1, 0]\n[[objects]]\nshape = 'chair'\nmaterial = 'm'\n");
  EXPECT_EQ(scene.triangle_count(), 2 * chair_triangle_count);
  EXPECT_EQ(scene.meshes.at(0).material, 1u);
  EXPECT_EQ(scene.meshes.at(1).material, 0u);
  EXPECT_EQ(scene.meshes.at(3).material, 1u) << "the frame's";
  EXPECT_EQ(bounds_of(scene.meshes.at(0)).lower().y, 1);
  EXPECT_NEAR(bounds_of(scene.meshes.at(0)).size().y, 2 * bounds_of(scene.meshes.at(2)).size().y, 1e-6);
}

TEST_F(SceneFileReads, lights) {
  const Scene scene = load(material + sphere +
                           "[[lights]]\nposition = [1, 2, 3]\n[[lights]]\nposition = [4, 5, 6]\n"
                           "colour = [1, 0.5, 0.25]\nintensity = 0.5\n");
  EXPECT_EQ(scene.lights.at(0).position, Vec3d(1, 2, 3));
  EXPECT_EQ(scene.lights.at(0).intensity, Colour(1, 1, 1));
  EXPECT_EQ(scene.lights.at(1).intensity, Colour(0.5, 0.25, 0.125));
}

TEST(scene_files, the_examples_load) {
  const std::string folder = RAYSWEEP_SOURCE_DIR "/experiments/scenes/";
  const Scene ball = load_scene_file(folder + "glass-ball.toml");
  EXPECT_EQ(ball.spheres.size(), 2u);
  EXPECT_EQ(ball.triangle_count(), chair_triangle_count + 12);
  // The second example is a mesh, which a build without Assimp does not read.
  if (!why_no_mesh_files().empty()) GTEST_SKIP() << why_no_mesh_files();
  const Scene mesh = load_scene_file(folder + "mesh.toml");
  ASSERT_EQ(mesh.meshes.size(), 4u);
  const auto pyramid = std::ranges::find(mesh.meshes, "pyramid", &Mesh::name);
  ASSERT_NE(pyramid, mesh.meshes.end());
  const Material& glass = mesh.materials.at(pyramid->material);
  EXPECT_NEAR(glass.k_refract, 0.8, 1e-6);
  EXPECT_NEAR(glass.filter.y, 0.25, 1e-6);
}

}  // namespace
}  // namespace raysweep
