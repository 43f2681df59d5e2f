// Rays that do not move along some axis, or hardly: the catalogue's N1, N2, N4 and N5 in the wide core. They
// go with all others, and hit what brute force hits.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/tracer/mixed_scene.h"
#include "tests/tracer/wide/batches.h"
#include "tracer/intersect/all.h"
#include "tracer/scene/shapes.h"

namespace raysweep {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr int side = 3;

/// Boxes side by side, `unit` large each, from `corner` on in every direction: faces lie on a lattice.
Scene boxes(double unit, double corner) {
  Mesh mesh;
  for (int i = 0; i < side * side * side; ++i) {
    const Vec3d lower = Vec3d(i % side, i / side % side, i / (side * side)) * unit + Vec3d(1, 1, 1) * corner;
    append_box(mesh, lower, lower + Vec3d(unit, unit, unit) * (i % 2 == 0 ? 1 : 0.5));
  }
  Scene scene;
  scene.materials = {{}};
  scene.meshes = {mesh};
  return scene;
}

/// Along each axis, either way, with `small` of either sign or 0 besides; from places within the boxes and
/// around them, on faces of the lattice, and a few units in the last place beside them.
std::vector<TestRay<float>> flat_rays(double unit, double corner, float small) {
  std::mt19937 random(11);
  const auto place = [&] {
    const double steps = static_cast<double>(random() % (8 * side + 17)) / 8 - 1;
    auto x = static_cast<float>(steps * unit + corner);
    for (auto ulps = random() % 3; ulps > 0; --ulps)
      x = std::nextafter(x, random() % 2 == 0 ? -1e30f : 1e30f);
    return x;
  };
  const auto little = [&] {
    return std::copysign(random() % 3 == 0 ? 0.0f : small, random() % 2 == 0 ? 1.0f : -1.0f);
  };
  std::vector<TestRay<float>> rays;
  for (int i = 0; i < 600; ++i) {
    Ray<float> ray{{place(), place(), place()}, {little(), little(), little()}};
    const float along = i % 2 == 0 ? 1.0f : -0.75f;
    (i % 3 == 0 ? ray.direction.x : i % 3 == 1 ? ray.direction.y : ray.direction.z) = along;
    if (i % 7 == 0)
      (i % 3 == 2 ? ray.direction.x : ray.direction.z) = 0.5f * along;  // flat on one axis alone
    rays.push_back({ray, i % 5 == 0 ? static_cast<float>(unit) : infinity});
  }
  return rays;
}

/// How many rays no kernel takes.
template <class Core>
size_t count_left_over(const Core& core, const std::vector<TestRay<float>>& tests) {
  const RayBatch rays = batch_of(tests);
  HitBatch hits(tests.size());
  KernelScratch scratch;
  core.closest(rays, hits, scratch);
  return scratch.left_over.size();
}

struct Place {
  double unit, corner;
};
constexpr Place places[] = {{1, 0}, {1, -1.5}, {0x1p-10, 1000}, {0x1p-30, 0}, {0x1p40, -0x1p41}, {1, 0x1p16}};
/// Nothing, subnormal, as small as flat ones may be, and as small as others may.
constexpr float smalls[] = {0, 1e-40f, 0x1p-61f, 0x1p-60f};

template <class Method>
void expect_flat_rays_agree() {
  for (const auto& [unit, corner] : places) {
    const Scene scene = boxes(unit, corner);
    const ScalarCore<float, Method> oracle(scene, "none", 1);
    for (const float small : smalls) {
      const auto rays = flat_rays(unit, corner, small);
      const Answers expected(oracle, rays);
      size_t hits = 0;
      for (const auto& hit : expected.nearest) hits += hit ? 1 : 0;
      EXPECT_GT(hits, rays.size() / 10);
      for_each_wide_core<Method>(scene, "sah", 4, [&](const auto& core, std::string_view isa) {
        EXPECT_EQ(count_differences(core, expected, rays), 0u)
            << isa << ' ' << Method::name << ", unit " << unit << " at " << corner << ", besides " << small;
        EXPECT_EQ(count_left_over(core, rays), 0u)
            << isa << ", unit " << unit << " at " << corner << ", " << small;
      });
    }
  }
}

TEST(wide_core, flat_rays_hit_what_brute_force_hits_and_go_with_all_others) {
  for_each_method([](auto method) { expect_flat_rays_agree<decltype(method)>(); });
}

TEST(wide_core, flat_rays_among_shapes_of_all_kinds_agree) {
  const Scene scene = mixed_scene();
  const ScalarCore<float, MollerTrumbore> oracle(scene, "none", 1);
  for (const float small : smalls) {
    const auto rays = flat_rays(0.5, -1, small);
    for_each_wide_core<MollerTrumbore>(scene, "sah", 4, [&](const auto& core, std::string_view isa) {
      EXPECT_EQ(count_differences(core, oracle, rays), 0u) << isa << ' ' << small;
    });
  }
}

TEST(wide_core, flat_rays_meet_planes_where_there_is_nothing_else) {
  Scene scene = mixed_scene();
  scene.spheres.clear();
  scene.meshes.clear();
  const ScalarCore<float, MollerTrumbore> oracle(scene, "none", 1);
  const auto rays = flat_rays(0.5, -1, 0);
  for_each_wide_core<MollerTrumbore>(scene, "sah", 4, [&](const auto& core, std::string_view isa) {
    EXPECT_EQ(count_differences(core, oracle, rays), 0u) << isa;
  });
}

/// Some that would move along a flat axis before they leave the scene, that never leave it, or that leave it
/// too late: these are left to exact traversal.
TEST(wide_core, flat_rays_beyond_their_bounds_are_left_over_and_agree) {
  const Scene scene = boxes(1, 0);
  const ScalarCore<float, MollerTrumbore> oracle(scene, "none", 1);
  const float slow = 0x1p-59f;
  const std::vector<TestRay<float>> rays{{{{0.25f, 0.25f, 0.25f}, {0, 0, 0}}, infinity},
                                         {{{0.25f, 0.25f, 0.25f}, {1e-40f, 1e-40f, 1e-40f}}, infinity},
                                         {{{1.5f, 0.25f, -1}, {0x1p-61f, 0, slow}}, infinity},
                                         {{{1.5f, 0.25f, -1}, {-0x1p-61f, 1e-40f, slow}}, infinity}};
  for_each_wide_core<MollerTrumbore>(scene, "sah", 4, [&](const auto& core, std::string_view isa) {
    EXPECT_EQ(count_differences(core, oracle, rays), 0u) << isa;
    EXPECT_EQ(count_left_over(core, rays), rays.size()) << isa;
  });
}

}  // namespace
}  // namespace raysweep
