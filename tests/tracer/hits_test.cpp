// Every core and hierarchy finds what brute force finds.
#include <gtest/gtest.h>

#include "tests/tracer/hit_rays.h"
#include "tests/tracer/mixed_scene.h"
#include "tests/tracer/scene_sizes.h"
#include "tracer/accel/m11.h"
#include "tracer/intersect/all.h"

namespace raysweep {
namespace {

template <class T, class Method>
void expect_agreement(const Scene& scene, size_t count) {
  const ScalarCore<T, Method> oracle(scene, "none", 1);
  const ScalarCore<T, Method> median(scene, "median", 4), sah(scene, "sah", 4), sbvh(scene, "sbvh", 4),
      wide_leaves(scene, "sah", 64);
  const M11Core<T, Method> m11(scene, "median", 16), m11_none(scene, "none", 1);
  for (const char* kind : {"primary", "shadow", "reflected", "random"}) {
    for (const TestRay<T>& ray : make_rays<T>(scene, sah, kind, count)) {
      ASSERT_TRUE(answers_agree(oracle, median, ray)) << Method::name << ' ' << kind;
      ASSERT_TRUE(answers_agree(oracle, sah, ray)) << Method::name << ' ' << kind;
      ASSERT_TRUE(answers_agree(oracle, sbvh, ray)) << Method::name << ' ' << kind;
      ASSERT_TRUE(answers_agree(oracle, wide_leaves, ray)) << Method::name << ' ' << kind;
      ASSERT_TRUE(answers_agree(oracle, m11, ray)) << Method::name << ' ' << kind;
      ASSERT_TRUE(answers_agree(oracle, m11_none, ray)) << Method::name << ' ' << kind;
    }
  }
}

TEST(hits, all_cores_and_hierarchies_agree_with_brute_force_on_every_scene_that_brute_force_can_take) {
  for (const BuiltInScene& built_in : scenes_up_to(brute_force_triangles)) {
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

/// The hit by the methods alone: no box, no tree, no `accept`.
template <class T, class Method>
Hit<T> plain_hit(const Scene& scene, const Ray<T>& ray) {
  Hit<T> nearest = Hit<T>::none();
  uint32_t id = 0;
  const auto keep = [&](std::optional<T> t) {
    if (t && Hit<T>{*t, id}.before(nearest)) nearest = {*t, id};
    id++;
  };
  for (const Plane& p : scene.planes) keep(intersect_plane(ray, Vec3<T>(p.normal), static_cast<T>(p.offset)));
  for (const Sphere& s : scene.spheres) {
    const auto hit = intersect_sphere(ray, Vec3<T>(s.centre), static_cast<T>(s.radius));
    if (!hit || hit->leave <= 0) {
      keep(std::nullopt);
    } else {
      keep(hit->enter > 0 ? hit->enter : hit->leave);
    }
  }
  for (const Mesh& mesh : scene.meshes) {
    for (const auto& [a, b, c] : mesh.triangles) {
      const auto hit = Method::intersect(
          ray, Method::prepare(Triangle<T>{Vec3<T>(mesh.vertices[a]), Vec3<T>(mesh.vertices[b]),
                                           Vec3<T>(mesh.vertices[c])}));
      keep(hit ? std::optional<T>(hit->t) : std::nullopt);
    }
  }
  return nearest;
}

/// `accept` may move a hit by rounding, and may drop one that grazes its triangle's border; it must not lose
/// surfaces.
TEST(hits, accepting_by_boxes_changes_distances_by_rounding_only) {
  for (const BuiltInScene& built_in : scenes_up_to(brute_force_triangles)) {
    const Scene scene = built_in.make(2);
    const ScalarCore<float, MollerTrumbore> core(scene, "sah", 4);
    int hits = 0;
    for (const char* kind : {"primary", "reflected"}) {
      for (const auto& test : make_rays<float>(scene, core, kind, 2000)) {
        const auto plain = plain_hit<float, MollerTrumbore>(scene, test.ray);
        const auto hit = core.closest(test.ray);
        ASSERT_EQ(plain.is_none(), !hit);
        if (!hit) continue;
        hits++;
        ASSERT_NEAR(hit->t, plain.t, 1e-5f * (1 + plain.t));
      }
    }
    EXPECT_GT(hits, 500);
  }
}

TEST(m11, visits_every_leaf_that_the_ray_passes_where_the_scalar_core_stops_at_the_nearest) {
  Scene scene;
  scene.materials = {{}};
  Mesh mesh;
  constexpr uint32_t walls = 100;
  for (uint32_t i = 0; i < walls; ++i) {
    const auto z = static_cast<float>(i);
    mesh.vertices.insert(mesh.vertices.end(), {{-1, -1, z}, {2, -1, z}, {-1, 2, z}});
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  scene.meshes = {mesh};
  const Ray<float> through_all{{0, 0, -1}, {0, 0, 1}};
  const auto count = [&](const auto& core) {
    CountingMethod::tests = 0;
    EXPECT_EQ(core.closest(through_all)->t, 1);
    return static_cast<int>(CountingMethod::tests);
  };
  EXPECT_EQ(count(M11Core<float, CountingMethod>(scene, "median", 1)), static_cast<int>(walls));
  EXPECT_EQ(count(ScalarCore<float, CountingMethod>(scene, "median", 1)), 1);
  EXPECT_EQ(count(ScalarCore<float, CountingMethod>(scene, "none", 1)), static_cast<int>(walls));
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
