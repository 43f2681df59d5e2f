// Every core and hierarchy finds what brute force finds.
#include <gtest/gtest.h>

#include "tests/tracer/hit_rays.h"
#include "tracer/accel/m11.h"
#include "tracer/intersect/all.h"
#include "tracer/scene/scenes.h"

namespace raysweep {
namespace {

/// Planes, spheres and triangles, some of them twice: ties are everywhere.
Scene mixed_scene() {
  Scene scene;
  scene.name = "mixed";
  scene.materials = {{}};
  scene.planes = {{{0, 1, 0}, 0, 0}, {{0, 1, 0}, 0, 0}};
  scene.spheres = {{{0, 0.5, 0}, 0.5, 0}, {{0, 0.5, 0}, 0.5, 0}, {{0.6, 0.4, 0.3}, 0.2, 0}};
  Mesh mesh;
  mesh.vertices = {{-1, 0, -1}, {1, 0, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, 0, 1}, {1, 0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 1, 2}, {0, 1, 5}, {0, 5, 4}, {0, 0, 1}};
  scene.meshes = {mesh, mesh};
  scene.lights = light_dome(3, {0, 0.5, 0}, 4);
  scene.camera = {.position = {0.3, 1, 4}, .target = {0, 0.5, 0}, .half_angle = 0.4};
  return scene;
}

template <class T, class Method>
void expect_agreement(const Scene& scene, size_t count) {
  const ScalarCore<T, Method> oracle(scene, "none", 1);
  const ScalarCore<T, Method> median(scene, "median", 4), sah(scene, "sah", 4), wide_leaves(scene, "sah", 64);
  const M11Core<T, Method> m11(scene, "median", 16), m11_none(scene, "none", 1);
  for (const char* kind : {"primary", "shadow", "reflected", "random"}) {
    for (const TestRay<T>& ray : make_rays<T>(scene, sah, kind, count)) {
      ASSERT_TRUE(answers_agree(oracle, median, ray)) << Method::name << ' ' << kind;
      ASSERT_TRUE(answers_agree(oracle, sah, ray)) << Method::name << ' ' << kind;
      ASSERT_TRUE(answers_agree(oracle, wide_leaves, ray)) << Method::name << ' ' << kind;
      ASSERT_TRUE(answers_agree(oracle, m11, ray)) << Method::name << ' ' << kind;
      ASSERT_TRUE(answers_agree(oracle, m11_none, ray)) << Method::name << ' ' << kind;
    }
  }
}

TEST(hits, all_cores_and_hierarchies_agree_with_brute_force_on_every_scene) {
  for (const BuiltInScene& built_in : built_in_scenes()) {
    for_each_method([&](auto method) {
      expect_agreement<float, decltype(method)>(built_in.make(2), 300);
      expect_agreement<double, decltype(method)>(built_in.make(2), 300);
    });
  }
}

TEST(hits, all_cores_and_hierarchies_agree_where_shapes_coincide) {
  for_each_method([&](auto method) {
    expect_agreement<float, decltype(method)>(mixed_scene(), 20000);
    expect_agreement<double, decltype(method)>(mixed_scene(), 20000);
  });
}

TEST(hits, of_equal_distances_the_lower_id_wins) {
  const Scene scene = mixed_scene();
  const ScalarCore<float, MollerTrumbore> scalar(scene, "sah", 1);
  const M11Core<float, MollerTrumbore> m11(scene, "median", 1);
  const Ray<float> down{{-0.8f, 3, 0.8f}, {0, -1, 0}};  // floor: planes 0 and 1, and triangles of both meshes
  EXPECT_EQ(scalar.closest(down)->id, 0u);
  EXPECT_EQ(m11.closest(down)->id, 0u);
  const Ray<float> at_the_spheres{{0, 0.5f, 4}, {0, 0, -1}};
  EXPECT_EQ(scalar.closest(at_the_spheres)->id, 2u);
  EXPECT_EQ(m11.closest(at_the_spheres)->id, 2u);
  const Ray<float> at_the_wall{{0.8f, 0.1f, -4}, {0, 0, 1}};
  EXPECT_EQ(scalar.closest(at_the_wall)->id, scalar.primitives().first_triangle())
      << "triangles 0, 2, 6 and 8 coincide";
  EXPECT_EQ(m11.closest(at_the_wall)->id, scalar.primitives().first_triangle());
}

}  // namespace
}  // namespace raysweep
