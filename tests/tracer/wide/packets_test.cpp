// Neighbours that go together get the answers that each gets alone, and they do go together.
#include <gtest/gtest.h>

#include <array>

#include "tests/tracer/mixed_scene.h"
#include "tests/tracer/scene_sizes.h"
#include "tests/tracer/wide/batches.h"
#include "tracer/intersect/all.h"

namespace raysweep {
namespace {

/// Of `rays`, how many a kernel that may take neighbours together has to take alone.
template <class Core>
size_t count_alone(const Core& core, const std::vector<TestRay<float>>& tests) {
  const RayBatch rays = batch_of(tests);
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

/// Neighbours which rise and fall on one axis, on two and on three, seen from in front, from inside and from
/// behind.
TEST(wide_core, packets_whose_directions_have_both_signs_on_axes_agree) {
  const Scene scene = mixed_scene();
  const ScalarCore<float, MollerTrumbore> oracle(scene, "sah", 4);
  for (size_t mixed = 0; mixed < 3; ++mixed) {
    for (const float spread : {0.01f, 0.3f}) {
      std::vector<TestRay<float>> one_axis, two_axes, three_axes;
      for (int i = 0; i < 3200; ++i) {
        const auto part = [](int k, int of) { return static_cast<float>(k % of) / static_cast<float>(of); };
        std::array<float, 3> direction{0.2f, 0.25f, 0.3f},
            origin{part(i, 7) * 0.1f, part(i, 5) * 0.1f, part(i, 3) * 0.1f};
        direction[mixed] = (part(i, 16) - 0.46f) * spread;
        const size_t along = (mixed + 1 + static_cast<size_t>(i) / 1600) % 3;
        direction[along] = (i / 400) % 2 == 0 ? -1.0f : 1.0f;
        origin[along] += static_cast<float>((i / 100) % 5 - 2) * 1.5f;
        origin[mixed] += static_cast<float>((i / 20) % 5 - 2) * 0.4f;
        const auto vector = [](const std::array<float, 3>& v) { return Vec3f(v[0], v[1], v[2]); };
        one_axis.push_back({{vector(origin), vector(direction)}, i % 2 == 0 ? 4.0f : 1e30f});
        direction[along] = part(i, 4) - 0.3f;
        two_axes.push_back({{vector(origin), vector(direction)}, i % 2 == 0 ? 4.0f : 1e30f});
        direction[3 - mixed - along] = part(i, 5) - 0.5f;
        three_axes.push_back({{vector(origin), vector(direction)}, 4.0f});
      }
      for_each_wide_core<MollerTrumbore>(scene, "sah", 4, [&](const auto& core, std::string_view isa) {
        for (const auto* rays : {&one_axis, &two_axes, &three_axes}) {
          EXPECT_EQ(count_differences(core, oracle, *rays), 0u) << isa << ' ' << mixed;
          EXPECT_LT(count_alone(core, *rays), rays->size() / 2) << isa << ' ' << mixed;
        }
      });
    }
  }
}

/// Triangles of a square across z.
Mesh square_across(float z) {
  constexpr uint32_t side = 5;
  Mesh mesh;
  for (uint32_t i = 0; i < side * side; ++i)
    mesh.vertices.emplace_back(static_cast<float>(i % side) - 2, static_cast<float>(i / side) - 2, z);
  for (uint32_t y = 0; y + 1 < side; ++y) {
    for (uint32_t x = 0; x + 1 < side; ++x) {
      const uint32_t a = y * side + x;
      mesh.triangles.push_back({a, a + 1, a + side});
      mesh.triangles.push_back({a + 1, a + side + 1, a + side});
    }
  }
  return mesh;
}

/// Rays of a packet that meet one square behind the other: whichever direction they go in, the first one that
/// is found to be in their way is the far one.
TEST(wide_core, packets_visit_far_children_first_where_any_hit_will_do) {
  Scene scene;
  scene.materials.emplace_back();
  scene.meshes = {square_across(-4), square_across(4)};
  const auto in_each = static_cast<uint32_t>(scene.meshes[0].triangles.size());
  for (const float along : {1.0f, -1.0f}) {
    std::vector<TestRay<float>> rays;
    for (size_t i = 0; i < packet_size; ++i) {
      const float beside = 0.01f * static_cast<float>(i);
      rays.push_back({{{0.3f + beside, 0.2f - beside, -9 * along}, {0.001f, 0.002f, along}}, 100.0f});
    }
    for_each_wide_core<MollerTrumbore>(scene, "sah", 4, [&](const auto& core, std::string_view isa) {
      HitBatch hits(rays.size());
      KernelScratch scratch;
      core.occluded(batch_of(rays), hits, scratch, Grouping::packets);
      for (size_t i = 0; i < rays.size(); ++i)
        EXPECT_EQ(hits.id[i] >= in_each, along > 0) << isa << ' ' << along << ' ' << i;
    });
  }
}

/// Batches that are no multiple of a packet, and a scene of nothing.
TEST(wide_core, packets_agree_in_batches_of_any_size_and_without_a_scene) {
  for (const Scene& scene : {mixed_scene(), Scene()}) {
    const ScalarCore<float, MollerTrumbore> oracle(scene, "sah", 4);
    for_each_wide_core<MollerTrumbore>(scene, "sah", 4, [&](const auto& core, std::string_view isa) {
      for (size_t size = 1; size <= 2 * packet_size + 1; ++size) {
        std::vector<TestRay<float>> rays;
        for (size_t i = 0; i < size; ++i)
          rays.push_back({{{0.01f * static_cast<float>(i), 0.1f, 3}, {0.1f, -0.05f, -1}}, 100.0f});
        EXPECT_EQ(count_differences(core, oracle, rays), 0u) << isa << ' ' << size;
      }
    });
  }
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
