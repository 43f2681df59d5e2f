// The fast core answers as the scalar one does, bit for bit, on every instruction set.
#include "tracer/wide/wide_core.h"

#include <gtest/gtest.h>

#include "tests/tracer/edge_rays.h"
#include "tests/tracer/mixed_scene.h"
#include "tests/tracer/scene_sizes.h"
#include "tests/tracer/wide/batches.h"
#include "tracer/intersect/all.h"

namespace raysweep {
namespace {

template <class Method>
void expect_agreement(const Scene& scene, const std::string& accel, int leaf, size_t count) {
  const ScalarCore<float, Method> oracle(scene, "sah", 4);
  for_each_wide_core<Method>(scene, accel, leaf, [&](const auto& core, std::string_view isa) {
    for (const char* kind : {"primary", "shadow", "reflected", "random"}) {
      const auto rays = make_rays<float>(scene, oracle, kind, count);
      EXPECT_EQ(count_differences(core, oracle, rays), 0u)
          << isa << ' ' << accel << ' ' << leaf << ' ' << kind;
    }
  });
}

TEST(wide_core, agrees_with_the_scalar_core_on_every_scene_and_instruction_set) {
  for (const BuiltInScene& built_in : scenes_up_to(brute_force_triangles)) {
    for_each_method(
        [&](auto method) { expect_agreement<decltype(method)>(built_in.make(2), "sah", 4, 500); });
  }
}

TEST(wide_core, agrees_where_shapes_coincide) {
  for_each_method([&](auto method) {
    for (const auto& [accel, leaf] : {std::pair("sah", 4), {"median", 1}, {"median", 5}, {"none", 4}})
      expect_agreement<decltype(method)>(mixed_scene(), accel, leaf, 5000);
  });
}

TEST(wide_core, agrees_with_leaves_of_many_blocks) {
  for (const int leaf : {1, 20, 300, 20000})
    expect_agreement<MollerTrumbore>(scenes_up_to(brute_force_triangles).front().make(1), "median", leaf,
                                     200);
}

/// Hits of an earlier batch, nearer than any or of rays that were hidden; with planes, which are asked before
/// kernels, and without.
TEST(wide_core, what_hits_held_before_does_not_matter) {
  for (const Scene& scene : {mixed_scene(), scenes_up_to(brute_force_triangles).front().make(1)}) {
    const ScalarCore<float, MollerTrumbore> oracle(scene, "sah", 4);
    const auto tests = make_rays<float>(scene, oracle, "shadow", 777);
    const RayBatch rays = batch_of(tests);
    for_each_wide_core<MollerTrumbore>(scene, "sah", 4, [&](const auto& core, std::string_view isa) {
      for (const Grouping grouping : {Grouping::single, Grouping::packets}) {
        HitBatch nearest(rays.size);
        std::ranges::fill(nearest.t, 0x1p-30f);
        std::ranges::fill(nearest.id, 0);
        HitBatch any = nearest;
        KernelScratch scratch;
        core.closest(rays, nearest, scratch, grouping);
        core.occluded(rays, any, scratch, grouping);
        size_t wrong = 0;
        for (size_t i = 0; i < rays.size; ++i) {
          const auto hit = oracle.closest(tests[i].ray, Hit<float>::start(), tests[i].t_max);
          wrong += nearest.id[i] != (hit ? hit->id : no_hit_id) ||
                   (any.id[i] != no_hit_id) != oracle.occluded(tests[i].ray, tests[i].t_max);
        }
        EXPECT_EQ(wrong, 0u) << isa;
      }
    });
  }
}

TEST(wide_core, a_scene_without_shapes_has_no_hits) {
  Scene empty;
  empty.camera = mixed_scene().camera;
  for_each_wide_core<MollerTrumbore>(empty, "sah", 4, [&](const auto& core, std::string_view) {
    RayBatch rays(3);
    for (size_t i = 0; i < 3; ++i) rays.set(i, {{0, 0, 0}, {0.6f, 0, 0.8f}});
    HitBatch hits(3);
    KernelScratch scratch;
    core.closest(rays, hits, scratch);
    EXPECT_EQ(hits.id[2], no_hit_id);
    EXPECT_EQ(hits.t[2], std::numeric_limits<float>::infinity());
  });
}

TEST(wide_core, batches_of_any_size_give_each_ray_its_own_answer) {
  const Scene scene = mixed_scene();
  const ScalarCore<float, MollerTrumbore> oracle(scene, "sah", 4);
  for_each_wide_core<MollerTrumbore>(scene, "sah", 4, [&](const auto& core, std::string_view isa) {
    for (const size_t count : {0, 1, 2, 31, 32, 33, 100}) {
      const auto rays = make_rays<float>(scene, oracle, "random", count);
      EXPECT_EQ(count_differences(core, oracle, rays), 0u) << isa << ' ' << count;
    }
  });
}

/// Directions along axes, with zeros of both signs, tiny and huge ones, and numbers that are none.
std::vector<TestRay<float>> odd_rays() {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const float numbers[] = {0,       -0.0f, 1,    -1,       1e-30f,
                           -1e-42f, 1e30f, 0.3f, infinity, std::numeric_limits<float>::quiet_NaN()};
  std::vector<TestRay<float>> rays;
  for (const Vec3f& origin : {Vec3f(0.1f, 0.5f, 3), Vec3f(0, 0, 0), Vec3f(-1, 0, 1), Vec3f(1e25f, 0, 0)}) {
    for (const float x : numbers) {
      for (const float y : numbers) {
        for (const float z : numbers) {
          rays.push_back({{origin, {x, y, z}}, infinity});
          rays.push_back({{origin, {x, y, z}}, 1.5f});
        }
      }
    }
  }
  return rays;
}

TEST(wide_core, agrees_on_rays_along_axes_and_on_numbers_that_are_none) {
  const Scene scene = mixed_scene();
  const ScalarCore<float, MollerTrumbore> oracle(scene, "none", 1);
  for_each_wide_core<MollerTrumbore>(scene, "sah", 4, [&](const auto& core, std::string_view isa) {
    EXPECT_EQ(count_differences(core, oracle, odd_rays()), 0u) << isa;
  });
}

TEST(wide_core, agrees_on_limits_before_at_and_behind_hits) {
  const Scene scene = mixed_scene();
  const ScalarCore<float, MollerTrumbore> oracle(scene, "none", 1);
  std::vector<TestRay<float>> rays;
  for (const auto& test : make_rays<float>(scene, oracle, "random", 300)) {
    for (const float limit : {0.0f, -0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN(), 1e-38f})
      rays.push_back({test.ray, limit});
    const auto hit = oracle.closest(test.ray);
    if (!hit) continue;
    for (const float limit : {std::nextafter(hit->t, 0.0f), hit->t, std::nextafter(hit->t, 2 * hit->t)})
      rays.push_back({test.ray, limit});
  }
  ASSERT_GT(rays.size(), 1600u);
  for_each_wide_core<MollerTrumbore>(scene, "sah", 4, [&](const auto& core, std::string_view isa) {
    EXPECT_EQ(count_differences(core, oracle, rays), 0u) << isa;
  });
}

/// Triangles each a third of the one before, one behind the other: halving their box sets one apart at a
/// time.
TEST(wide_core, agrees_in_a_hierarchy_as_deep_as_they_get) {
  Scene scene = mixed_scene();
  scene.planes.clear();
  scene.spheres.clear();
  scene.meshes = {Mesh{}};
  float at = 1;
  for (uint32_t i = 0; i < 75; ++i, at /= 3) {
    for (int copy = 0; copy < 3; ++copy) {
      const auto first = static_cast<uint32_t>(scene.meshes[0].vertices.size());
      scene.meshes[0].vertices.insert(scene.meshes[0].vertices.end(), {{at, 0, 0}, {at, at, 0}, {at, 0, at}});
      scene.meshes[0].triangles.push_back({first, first + 1, first + 2});
    }
  }
  const ScalarCore<float, MollerTrumbore> oracle(scene, "none", 1);
  std::vector<TestRay<float>> rays;
  for (int i = 1; i < 40; ++i) {
    const float aim = std::pow(0.5f, static_cast<float>(i));
    rays.push_back({{{2, aim / 3, aim / 4}, normalize(Vec3f(-1, -aim / 7, -aim / 9))}, 1e30f});
    rays.push_back({{{-1, aim / 3, aim / 4}, normalize(Vec3f(1, -aim / 7, aim / 9))}, 1e30f});
  }
  for_each_wide_core<MollerTrumbore>(scene, "median", 1, [&](const auto& core, std::string_view isa) {
    EXPECT_EQ(count_differences(core, oracle, rays), 0u) << isa;
  });
}

/// Case W8 of the failure catalogue, where floats alone cannot decide: exactly at edges and corners, and
/// beside them by rounding. The kernels use multiply-adds where an instruction set has them.
TEST(wide_core, w8_agrees_at_edges_and_corners_on_every_instruction_set) {
  std::mt19937 random(3);
  const Scene scene = scene_of({sheet(16, 0, random), rough_sphere(16, 16, random)});
  std::vector<TestRay<float>> rays;
  for (int i = 0; i < 30'000; ++i) {
    const Mesh& mesh = scene.meshes[random() % 2];
    const Vec3d target = point_on_border(mesh, mesh.triangles[random() % mesh.triangles.size()], random);
    // Of whole numbers of eighths, so that nothing is rounded on the way to the sheet's corners.
    const auto eighths = [&] { return static_cast<double>(random() % 16 + 1) / 8; };
    const double x = eighths(), y = eighths();
    const Vec3d origin(x, y, 4);
    rays.push_back({{Vec3f(origin), Vec3f(target - origin)}, std::numeric_limits<float>::infinity()});
    rays.push_back({ray_towards<float>(origin * 0.3, target), std::numeric_limits<float>::infinity()});
  }
  // Sixteen at a time to one triangle, from where all go the same way.
  for (int i = 0; i < 3'000; ++i) {
    const Mesh& mesh = scene.meshes[random() % 2];
    const auto& triangle = mesh.triangles[random() % mesh.triangles.size()];
    const Vec3d origin(3, 2.5, 4);
    for (int k = 0; k < 16; ++k)
      rays.push_back({{Vec3f(origin), Vec3f(point_on_border(mesh, triangle, random) - origin)},
                      std::numeric_limits<float>::infinity()});
  }
  for_each_method([&](auto method) {
    using Method = decltype(method);
    const ScalarCore<float, Method> oracle(scene, "sah", 4);
    for_each_wide_core<Method>(scene, "sah", 4, [&](const auto& core, std::string_view isa) {
      EXPECT_EQ(count_differences(core, oracle, rays), 0u) << isa << ' ' << Method::name;
    });
  });
}

/// Limits and offsets are relative: no scene is too small or too large.
TEST(wide_core, agrees_in_scenes_of_any_size) {
  for (const float scale : {1e-12f, 1e-3f, 1e3f, 1e6f, 1e15f, 1e18f, 4e18f}) {
    Scene scene = mixed_scene();
    for (Mesh& mesh : scene.meshes) {
      for (Vec3f& vertex : mesh.vertices) vertex = vertex * scale;
    }
    for (Sphere& sphere : scene.spheres) {
      sphere.centre = sphere.centre * double{scale};
      sphere.radius *= double{scale};
    }
    for (Light& light : scene.lights) light.position = light.position * double{scale};
    scene.camera.position = scene.camera.position * double{scale};
    scene.camera.target = scene.camera.target * double{scale};
    const ScalarCore<float, MollerTrumbore> oracle(scene, "none", 1);
    for_each_wide_core<MollerTrumbore>(scene, "sah", 4, [&](const auto& core, std::string_view isa) {
      for (const char* kind : {"primary", "reflected"})
        EXPECT_EQ(count_differences(core, oracle, make_rays<float>(scene, oracle, kind, 300)), 0u)
            << isa << ' ' << scale;
    });
  }
}

/// What glass asks of a core.
TEST(wide_core, shows_every_hit_of_a_ray_and_finds_the_next_one) {
  const Scene scene = mixed_scene();
  const ScalarCore<float, MollerTrumbore> oracle(scene, "none", 1);
  for_each_wide_core<MollerTrumbore>(scene, "sah", 4, [&](const auto& core, std::string_view) {
    for (const auto& test : make_rays<float>(scene, oracle, "random", 500)) {
      const auto all = [&](const auto& any_core) {
        std::vector<Hit<float>> hits;
        any_core.visit_hits(test.ray, 3.0f, [&](const Hit<float>& hit) {
          hits.push_back(hit);
          return false;
        });
        std::ranges::sort(hits, [](const auto& a, const auto& b) { return a.before(b); });
        return hits;
      };
      const auto expected = all(oracle), found = all(core);
      ASSERT_EQ(found.size(), expected.size());
      Hit<float> last = Hit<float>::start();
      for (size_t i = 0; i < found.size(); ++i) {
        ASSERT_EQ(found[i].id, expected[i].id);
        const auto next = core.closest(test.ray, last);
        ASSERT_TRUE(next);
        ASSERT_EQ(next->id, expected[i].id);
        ASSERT_EQ(next->t, expected[i].t);
        last = *next;
      }
    }
  });
}

TEST(wide_core, every_machine_has_an_instruction_set) {
  EXPECT_FALSE(built_isas().empty());
  EXPECT_TRUE(runs_here(built_isas().back().name)) << "the last is what the program is compiled for";
  EXPECT_TRUE(runs_here(best_isa()));
  EXPECT_FALSE(runs_here("best")) << "a word of settings, no instruction set";
}

}  // namespace
}  // namespace raysweep
