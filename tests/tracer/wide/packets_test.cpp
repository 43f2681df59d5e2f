// Neighbours that go together get the answers that each gets alone, and they do go together.
#include <gtest/gtest.h>

#include "tests/tracer/mixed_scene.h"
#include "tests/tracer/scene_sizes.h"
#include "tests/tracer/wide/batches.h"
#include "tracer/intersect/all.h"

namespace raysweep {
namespace {

/// Of `rays`, how many a kernel that may take neighbours together has to take alone.
template <class Core>
size_t count_alone(const Core& core, const std::vector<TestRay<float>>& tests) {
  RayBatch rays(tests.size());
  for (size_t i = 0; i < tests.size(); ++i) rays.set(i, tests[i].ray, tests[i].t_max);
  HitBatch hits(tests.size());
  KernelScratch scratch;
  if (tests[0].t_max < std::numeric_limits<float>::infinity()) {
    core.occluded(rays, hits, scratch);
  } else {
    core.closest(rays, hits, scratch);
  }
  return scratch.groups.size() * packet_size;
}

template <class Method>
void expect_agreeing_neighbours(const BuiltInScene& built_in) {
  constexpr size_t count = 1600;
  const Scene scene = built_in.make(2);
  const ScalarCore<float, Method> oracle(scene, "sah", 4);
  for_each_wide_core<Method>(scene, "sah", 4, [&](const auto& core, std::string_view isa) {
    for (const char* kind : {"primary", "shadow", "reflected"}) {
      const auto rays = make_rays<float>(scene, oracle, kind, count, PixelOrder::blocks);
      EXPECT_EQ(count_differences(core, oracle, rays), 0u) << built_in.name << ' ' << isa << ' ' << kind;
      if (kind == std::string("primary")) {
        EXPECT_LT(count_alone(core, rays), count / 2) << built_in.name << ' ' << isa;
      }
    }
  });
}

TEST(wide_core, neighbours_go_together_and_agree) {
  for (const BuiltInScene& built_in : scenes_up_to(brute_force_triangles))
    for_each_method([&](auto method) { expect_agreeing_neighbours<decltype(method)>(built_in); });
}

/// Rays side by side towards one point each, from far apart or from close by: the longest of limits take the
/// ends of such rays beyond what floats hold.
TEST(wide_core, rays_towards_distant_points_agree) {
  const Scene scene = mixed_scene();
  const ScalarCore<float, MollerTrumbore> oracle(scene, "sah", 4);
  std::vector<TestRay<float>> rays;
  for (const float limit : {3.0f, 1e6f, 1e30f, std::numeric_limits<float>::max()}) {
    for (const Vec3f& direction : {Vec3f(1, 2, 2), Vec3f(0.1f, -1, -0.2f), Vec3f(-0.3f, -0.2f, -0.9f)}) {
      for (int i = 0; i < 1600; ++i) {
        const Vec3f beside(static_cast<float>(i % 40) * 0.05f - 1, static_cast<float>(i / 40) * 0.05f - 1, 0);
        rays.push_back({{beside - direction * 2, direction}, limit});
      }
    }
  }
  for_each_wide_core<MollerTrumbore>(scene, "sah", 4, [&](const auto& core, std::string_view isa) {
    EXPECT_EQ(count_differences(core, oracle, rays), 0u) << isa;
    EXPECT_LT(count_alone(core, rays), rays.size() / 2) << isa;
  });
}

/// Neighbours that differ in their limits alone.
TEST(wide_core, packets_agree_on_limits_before_at_and_behind_hits) {
  const Scene scene = mixed_scene();
  const ScalarCore<float, MollerTrumbore> oracle(scene, "none", 1);
  std::vector<TestRay<float>> rays;
  for (const auto& test : make_rays<float>(scene, oracle, "random", 300)) {
    const auto hit = oracle.closest(test.ray);
    const float t = hit ? hit->t : 1;
    for (const float limit : {0.0f, -0.0f, -1.0f, 1e-38f, t / 2, std::nextafter(t, 0.0f), t,
                              std::nextafter(t, 2 * t), 2 * t, 1e30f, std::numeric_limits<float>::max(),
                              std::numeric_limits<float>::infinity(), -t, 0.1f, 10.0f, -1e30f})
      rays.push_back({test.ray, limit});
  }
  ASSERT_EQ(rays.size() % packet_size, 0u);
  for_each_wide_core<MollerTrumbore>(scene, "sah", 4, [&](const auto& core, std::string_view isa) {
    EXPECT_EQ(count_differences(core, oracle, rays), 0u) << isa;
    EXPECT_LT(count_alone(core, rays), rays.size() / 2) << isa;
  });
}

}  // namespace
}  // namespace raysweep
