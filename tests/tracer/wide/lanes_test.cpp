// Case V2 of the failure catalogue: what a ray hits does not depend on its lane, nor on what other lanes
// hold; idle lanes stay as they were.
#include <gtest/gtest.h>

#include "tests/tracer/mixed_scene.h"
#include "tests/tracer/wide/batches.h"
#include "tracer/intersect/all.h"

namespace raysweep {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float mark = -12345;
constexpr uint32_t mark_id = 54321;

/// Rays that hit and rays that miss; every other one of those that hit ends before.
std::vector<TestRay<float>> some_rays(const ScalarCore<float, MollerTrumbore>& core, const Scene& scene) {
  std::vector<TestRay<float>> rays = make_rays<float>(scene, core, "random", 40);
  for (size_t i = 0; i < rays.size(); i += 4) {
    if (const auto hit = core.closest(rays[i].ray)) rays[i].t_max = hit->t / 2;
  }
  rays.push_back({{{0.3f, 2, 0.2f}, {0, -1, 0}}, infinity});  // along an axis
  return rays;
}

/// Lanes up to `size`, and marks in those behind.
struct MarkedHits : HitBatch {
  explicit MarkedHits(size_t size) : HitBatch(size) {
    for (size_t i = size; i < t.size(); ++i) {
      t[i] = mark;
      id[i] = mark_id;
    }
  }
  [[nodiscard]] size_t changed_from(size_t size) const {
    size_t count = 0;
    for (size_t i = size; i < t.size(); ++i) count += t[i] == mark && id[i] == mark_id ? 0 : 1;
    return count;
  }
};

/// Calls `check(oracle, core, grouping, name)` with the core wide of each method and instruction set in both
/// groupings; `oracle` is the scalar core by brute force.
template <class Check>
void with_every_kernel(const Scene& scene, Check&& check) {
  for_each_method([&](auto method) {
    using Method = decltype(method);
    const ScalarCore<float, Method> oracle(scene, "none", 1);
    for_each_wide_core<Method>(scene, "sah", 4, [&](const auto& core, std::string_view isa) {
      for (const Grouping grouping : {Grouping::single, Grouping::packets})
        check(oracle, core, grouping, std::string(isa) + ' ' + std::string(Method::name));
    });
  });
}

/// Lanes of `rays` whose answers are not the oracle's, and idle ones that were written to.
template <class Oracle, class Core>
size_t count_wrong_lanes(const Oracle& oracle, const Core& core, Grouping grouping, const RayBatch& rays) {
  MarkedHits nearest(rays.size), any(rays.size);
  KernelScratch scratch;
  core.closest(rays, nearest, scratch, grouping);
  core.occluded(rays, any, scratch, grouping);
  size_t wrong = nearest.changed_from(rays.size) + any.changed_from(rays.size);
  for (size_t i = 0; i < rays.size; ++i) {
    const auto hit = oracle.closest(rays.ray(i), Hit<float>::start(), rays.t_max[i]);
    const bool same = hit ? nearest.id[i] == hit->id && nearest.t[i] == hit->t
                          : nearest.id[i] == no_hit_id && nearest.t[i] == rays.t_max[i];
    const bool same_shadow = (any.id[i] != no_hit_id) == oracle.occluded(rays.ray(i), rays.t_max[i]);
    wrong += same && same_shadow ? 0 : 1;
  }
  return wrong;
}

TEST(lanes, v2_a_ray_hits_the_same_in_every_lane_of_full_and_of_partial_packets) {
  const Scene scene = mixed_scene();
  const auto tests = some_rays(ScalarCore<float, MollerTrumbore>(scene, "sah", 4), scene);
  with_every_kernel(scene, [&](const auto& oracle, const auto& core, Grouping grouping, const auto& name) {
    for (const size_t size : {1, 2, 3, 4, 5, 7, 8, 9, 12, 15, 16, 17, 31, 32}) {
      for (const auto& [ray, t_max] : tests) {
        RayBatch rays(size);
        for (size_t i = 0; i < size; ++i) rays.set(i, ray, t_max);
        ASSERT_EQ(count_wrong_lanes(oracle, core, grouping, rays), 0u) << name << ' ' << size;
      }
    }
  });
}

/// Neighbours that are masked out in one way or another: they end at once, point away from everything, are
/// not for kernels, or are no rays at all.
TEST(lanes, v2_a_ray_hits_the_same_whatever_its_neighbours_are) {
  const Scene scene = mixed_scene();
  const auto tests = some_rays(ScalarCore<float, MollerTrumbore>(scene, "sah", 4), scene);
  with_every_kernel(scene, [&](const auto& oracle, const auto& core, Grouping grouping, const auto& name) {
    for (size_t i = 0; i < tests.size(); ++i) {
      const auto& [ray, t_max] = tests[i];
      const float none = std::numeric_limits<float>::quiet_NaN();
      const std::pair<Ray<float>, float> neighbours[] = {
          {ray, 0.0f},
          {{{50, 50, 50}, ray.direction}, 1e-3f},
          {{ray.origin, {0, ray.direction.y, ray.direction.z}}, infinity},
          {{ray.origin, {none, ray.direction.y, ray.direction.z}}, infinity},
          {{{ray.origin.x, infinity, ray.origin.z}, ray.direction}, infinity}};
      for (const auto& [other, its_limit] : neighbours) {
        RayBatch rays(packet_size);
        for (size_t lane = 0; lane < packet_size; ++lane) rays.set(lane, other, its_limit);
        rays.set(i % packet_size, ray, t_max);
        rays.set((5 * i + 3) % packet_size, ray, t_max);
        ASSERT_EQ(count_wrong_lanes(oracle, core, grouping, rays), 0u) << name << ' ' << i;
      }
    }
  });
}

}  // namespace
}  // namespace raysweep
