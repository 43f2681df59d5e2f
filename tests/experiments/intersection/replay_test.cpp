// What is replayed is what the tracer does.
#include "experiments/intersection/replay.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "tests/tracer/hit_rays.h"
#include "tracer/scene/scenes.h"

namespace raysweep {
namespace {

constexpr int width = 32, height = 24;

class Replay : public testing::Test {
 public:
  Scene scene = triangles_alone(load_scene("grotto"));
  OracleCore core{scene, "sah", 4};

  [[nodiscard]] Workload<float> recorded(RayKind kind) const {
    return record_replay(scene, core, {kind}, width, height, 1);
  }
};

/// The t of the nearest hit of each ray's tests.
std::vector<std::optional<float>> nearest_hits(const Workload<float>& work) {
  std::vector<std::optional<float>> nearest(work.rays.size());
  for (const Visit<float>& visit : work.visits) {
    for (uint32_t i = visit.first_triangle; i < visit.first_triangle + visit.triangle_count; ++i) {
      const auto hit =
          MollerTrumbore::intersect(work.rays[visit.first_ray], MollerTrumbore::prepare(work.triangles[i]));
      std::optional<float>& best = nearest[visit.first_ray];
      if (hit && hit->t < visit.t_max && !(best && *best <= hit->t)) best = hit->t;
    }
  }
  return nearest;
}

TEST_F(Replay, has_the_hits_of_the_tracer) {
  for (const RayKind kind : {RayKind::primary, RayKind::diffuse}) {
    const Workload<float> work = recorded(kind);
    const auto nearest = nearest_hits(work);
    size_t hits = 0;
    for (size_t i = 0; i < work.rays.size(); ++i) {
      const auto hit = core.closest(work.rays[i]);
      ASSERT_EQ(nearest[i].has_value(), hit.has_value()) << i;
      if (!hit) continue;
      ++hits;
      EXPECT_EQ(*nearest[i], hit->t) << i;
    }
    EXPECT_GT(hits, 100u);
  }
}

TEST_F(Replay, stops_shadow_rays_where_the_tracer_does) {
  const Workload<float> work = recorded(RayKind::shadow);
  const auto nearest = nearest_hits(work);
  const RayBatch rays = make_rays(RayKind::shadow, scene, core, width, height, 1);
  ASSERT_EQ(rays.size, work.rays.size());
  size_t occluded = 0;
  for (size_t i = 0; i < rays.size; ++i) {
    EXPECT_EQ(nearest[i].has_value(), core.occluded(rays.ray(i), rays.t_max[i])) << i;
    occluded += nearest[i].has_value();
  }
  EXPECT_GT(occluded, 10u);
}

TEST_F(Replay, a_visit_ends_at_the_nearest_hit_so_far) {
  Workload<float> work = recorded(RayKind::diffuse);
  const auto visits = std::exchange(work.visits, {});
  std::vector<float> so_far(work.rays.size(), std::numeric_limits<float>::infinity());
  size_t shortened = 0;
  for (const Visit<float>& visit : visits) {
    float& nearest = so_far[visit.first_ray];
    EXPECT_EQ(visit.t_max, nearest);
    shortened += std::isfinite(visit.t_max);
    work.visits = {visit};
    nearest = nearest_hits(work)[visit.first_ray].value_or(nearest);
  }
  EXPECT_GT(shortened, 50u);
}

TEST_F(Replay, a_shadow_ray_visits_nothing_after_its_first_hit) {
  Workload<float> work = recorded(RayKind::shadow);
  const auto visits = std::exchange(work.visits, {});
  for (size_t i = 0; i + 1 < visits.size(); ++i) {
    if (visits[i].first_ray != visits[i + 1].first_ray) continue;
    work.visits = {visits[i]};
    EXPECT_FALSE(nearest_hits(work)[visits[i].first_ray]);
  }
}

TEST_F(Replay, does_as_many_tests_as_the_tracer) {
  const ScalarCore<float, CountingMethod> counting(scene, "sah", 4);
  CountingMethod::tests = 0;
  const Workload<float> work = recorded(RayKind::diffuse);
  for (const Ray<float>& ray : work.rays) static_cast<void>(counting.closest(ray));
  EXPECT_EQ(work.test_count(), static_cast<uint64_t>(CountingMethod::tests));
}

TEST(replay, of_a_scene_depends_on_its_seed_by_bounced_rays) {
  const Workload<float> a = replay_work("grotto", 1), b = replay_work("grotto", 1),
                        c = replay_work("grotto", 2);
  EXPECT_EQ(a.test_count(), b.test_count());
  EXPECT_NE(a.test_count(), c.test_count());
  EXPECT_GT(a.rays.size(), 10'000u);
  EXPECT_LE(a.rays.size(), 3u * 96 * 72);
}

}  // namespace
}  // namespace raysweep
