// Where items are cut, every core finds what brute force finds, and shows each hit once.
#include <gtest/gtest.h>

#include "tests/tracer/sticks.h"
#include "tests/tracer/wide/batches.h"
#include "tracer/accel/m11.h"
#include "tracer/intersect/all.h"

namespace raysweep {
namespace {

/// Rays as rendering sends them out; from far away; and in the planes of triangles but for rounding, where
/// methods see triangles that are not there.
template <class T>
std::vector<TestRay<T>> rays_among(const Scene& scene, size_t count) {
  constexpr T infinity = std::numeric_limits<T>::infinity();
  const ScalarCore<T, MollerTrumbore> core(scene, "sah", 4);
  std::vector<TestRay<T>> rays;
  for (const char* kind : {"primary", "shadow", "reflected", "random"}) {
    for (const TestRay<T>& ray : make_rays<T>(scene, core, kind, count)) rays.push_back(ray);
  }
  std::mt19937 random(7);
  std::uniform_real_distribution<T> uniform(-2, 2);
  const Mesh& mesh = scene.meshes[0];
  while (rays.size() < 6 * count) {
    const auto& triangle = mesh.triangles[random() % mesh.triangles.size()];
    const Vec3<T> a(mesh.vertices[triangle[0]]), b(mesh.vertices[triangle[1]]), c(mesh.vertices[triangle[2]]);
    const auto in_plane = [&] { return a + (b - a) * uniform(random) + (c - a) * uniform(random); };
    const Vec3<T> target = in_plane();
    const Vec3<T> grazing = in_plane(), far = target + (a - grazing) * T(1e5) + cross(b - a, c - a) * T(3e5);
    for (const Vec3<T>& origin : {grazing, far})
      if (length(target - origin) > 0) rays.push_back({{origin, target - origin}, infinity});
  }
  return rays;
}

/// All that a ray meets before `t_max`, as the core shows it, in order.
template <class T, class Core>
std::vector<std::pair<T, uint32_t>> all_hits(const Core& core, const Ray<T>& ray, T t_max) {
  std::vector<std::pair<T, uint32_t>> hits;
  core.visit_hits(ray, t_max, [&](const Hit<T>& hit) {
    hits.emplace_back(hit.t, hit.id);
    return false;
  });
  std::ranges::sort(hits);
  return hits;
}

template <class T, class Method>
void expect_agreement(const Scene& scene, size_t count) {
  const ScalarCore<T, Method> oracle(scene, "none", 1), one(scene, "sbvh", 1), four(scene, "sbvh", 4);
  const M11Core<T, Method> m11(scene, "sbvh", 2);
  ASSERT_GT(one.tree().order.size(), oracle.primitives().boxes().size()) << "something is cut";
  size_t several = 0;
  for (const TestRay<T>& ray : rays_among<T>(scene, count)) {
    ASSERT_TRUE(answers_agree(oracle, one, ray)) << Method::name;
    ASSERT_TRUE(answers_agree(oracle, four, ray)) << Method::name;
    ASSERT_TRUE(answers_agree(oracle, m11, ray)) << Method::name;
    const auto expected = all_hits(oracle, ray.ray, ray.t_max);
    ASSERT_EQ(all_hits(one, ray.ray, ray.t_max), expected) << Method::name;
    ASSERT_EQ(all_hits(m11, ray.ray, ray.t_max), expected) << Method::name;
    several += expected.size() > 1 ? 1 : 0;
  }
  EXPECT_GT(several, count / 2);
}

TEST(sbvh_hits, all_cores_agree_with_brute_force_where_items_are_cut) {
  const Scene scene = sticks(900, 100);
  for_each_method([&](auto method) {
    expect_agreement<float, decltype(method)>(scene, 300);
    expect_agreement<double, decltype(method)>(scene, 300);
  });
}

TEST(sbvh_hits, scenes_of_any_size_agree) {
  for (const float scale : {1e-9f, 1e-3f, 1e4f, 1e9f}) {
    SCOPED_TRACE(scale);
    expect_agreement<float, MollerTrumbore>(sticks(900, 100, scale), 200);
  }
}

TEST(sbvh_hits, the_wide_core_agrees_where_items_are_cut) {
  const Scene scene = sticks(900, 100);
  for_each_method([&](auto method) {
    using Method = decltype(method);
    const ScalarCore<float, Method> oracle(scene, "none", 1);
    const auto rays = rays_among<float>(scene, 1000);
    const Answers expected(oracle, rays);
    for_each_wide_core<Method>(scene, "sbvh", 4, [&](const auto& core, std::string_view isa) {
      EXPECT_EQ(count_differences(core, expected, rays), 0u) << isa << ' ' << Method::name;
      for (size_t i = 0; i < rays.size(); i += 10) {
        ASSERT_EQ(all_hits(core, rays[i].ray, rays[i].t_max), all_hits(oracle, rays[i].ray, rays[i].t_max))
            << isa;
      }
    });
  });
}

}  // namespace
}  // namespace raysweep
