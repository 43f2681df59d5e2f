// Embree finds what brute force finds, packets find what single rays find.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/tracer/hit_rays.h"
#include "tracer/peers/embree_rays.h"
#include "tracer/peers/flush_denormals.h"
#include "tracer/scene/scenes.h"

namespace raysweep {
namespace {

constexpr size_t ray_count = 20'000;

// Embree is not made to agree with us bit by bit: at edges, and where rays start close to a surface, one of
// the two may miss what the other hits. In all of these tests none does; a few may where compilers or
// processors round otherwise.
constexpr size_t most_differing = 3;

/// A scene's meshes alone.
Scene triangles_of(const std::string& name) {
  Scene scene = load_scene(name);
  scene.planes.clear();
  scene.spheres.clear();
  return scene;
}

using Oracle = ScalarCore<float, MollerTrumbore>;

/// Brute force where that takes seconds, else our hierarchy, which other tests hold against it bit by bit.
Oracle oracle_of(const Scene& scene) {
  return Oracle(scene, scene.triangle_count() < 2'000 ? "none" : "sah", 4);
}

RayBatch batch_of(const std::vector<TestRay<float>>& rays) {
  RayBatch batch(rays.size());
  for (size_t i = 0; i < rays.size(); ++i) batch.set(i, rays[i].ray, rays[i].t_max);
  return batch;
}

/// Rays of all kinds that ask for the nearest hit.
RayBatch nearest_rays(const Scene& scene, const Oracle& core, size_t count = ray_count) {
  std::vector<TestRay<float>> all;
  for (const char* kind : {"primary", "reflected", "random"}) {
    const auto rays = make_rays<float>(scene, core, kind, count);
    all.insert(all.end(), rays.begin(), rays.end());
  }
  return batch_of(all);
}

/// Whether two hits of a ray are at distances that only rounding tells apart: where faces touch or share an
/// edge, either is right.
bool are_in_the_same_place(float t, float other) { return std::abs(t / other - 1) < 1e-5f; }

struct Found {
  size_t differing = 0;  // another triangle, at another distance, or one of the two hit nothing
  size_t hit = 0;
};

Found against_oracle(const Oracle& core, const RayBatch& rays, const HitBatch& hits) {
  Found found;
  for (size_t i = 0; i < rays.size; ++i) {
    const auto hit = core.closest(rays.ray(i), Hit<float>::start(), rays.t_max[i]);
    found.hit += hit.has_value();
    if ((hit ? hit->id : no_hit_id) == hits.id[i]) {
      if (hit && !(std::abs(hits.t[i] / hit->t - 1) < 1e-3f)) ADD_FAILURE() << "ray " << i << ": distance";
      continue;
    }
    found.differing += !(hit && hits.id[i] != no_hit_id && are_in_the_same_place(hits.t[i], hit->t));
  }
  return found;
}

HitBatch trace(const EmbreeScene& scene, const RayBatch& rays, bool any_hit, int width, bool coherent) {
  const auto packets = make_embree_rays(width);
  packets->prepare(rays, any_hit);
  packets->trace(scene, coherent);
  packets->reset();  // as between two timed runs
  packets->trace(scene, coherent);
  return packets->hits(scene);
}

std::vector<EmbreeBuild> all_builds() {
  std::vector<EmbreeBuild> builds;
  for (const char* isa : {"avx2", "avx512"}) {
    try {
      const EmbreeScene probe({isa, false, false});
    } catch (const EmbreeError&) {
      continue;
    }
    for (const bool high : {false, true})
      for (const bool robust : {false, true}) builds.push_back({isa, high, robust});
  }
  return builds;
}

class EmbreeOnScene : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(scenes, EmbreeOnScene, testing::Values("chair-ball", "cornell-glass"),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST_P(EmbreeOnScene, finds_the_triangles_that_brute_force_finds) {
  const Scene scene = triangles_of(GetParam());
  const Oracle core = oracle_of(scene);
  const RayBatch rays = nearest_rays(scene, core);
  for (const EmbreeBuild& how : all_builds()) {
    EmbreeScene embree(how);
    embree.build(scene);
    const Found found = against_oracle(core, rays, trace(embree, rays, false, 1, false));
    EXPECT_LE(found.differing, most_differing) << how.name();
    EXPECT_GT(found.hit, rays.size / 20) << "the test sees little";
  }
}

TEST_P(EmbreeOnScene, knows_which_lights_are_hidden) {
  const Scene scene = triangles_of(GetParam());
  const Oracle core = oracle_of(scene);
  const RayBatch rays = batch_of(make_rays<float>(scene, core, "shadow", ray_count));
  for (const EmbreeBuild& how : all_builds()) {
    EmbreeScene embree(how);
    embree.build(scene);
    const HitBatch hits = trace(embree, rays, true, 1, false);
    size_t differing = 0, hidden = 0;
    for (size_t i = 0; i < rays.size; ++i) {
      const bool occluded = core.occluded(rays.ray(i), rays.t_max[i]);
      hidden += occluded;
      differing += occluded != (hits.id[i] != no_hit_id);
    }
    EXPECT_LE(differing, most_differing) << how.name();
    EXPECT_GT(hidden, rays.size / 20) << "the test sees little";
  }
}

TEST_P(EmbreeOnScene, packets_find_what_single_rays_find) {
  const Scene scene = triangles_of(GetParam());
  const Oracle core = oracle_of(scene);
  // A last packet that is not full, of any width.
  const RayBatch nearest = nearest_rays(scene, core, 1'001);
  const RayBatch shadow = batch_of(make_rays<float>(scene, core, "shadow", 1'001));
  for (const EmbreeBuild& how : all_builds()) {
    EmbreeScene embree(how);
    embree.build(scene);
    for (const bool any_hit : {false, true}) {
      const RayBatch& rays = any_hit ? shadow : nearest;
      const HitBatch single = trace(embree, rays, any_hit, 1, false);
      for (const int width : {1, 4, 8, 16}) {
        for (const bool coherent : {false, true}) {
          const HitBatch packets = trace(embree, rays, any_hit, width, coherent);
          size_t differing = 0;
          for (size_t i = 0; i < rays.size; ++i) {
            if (packets.id[i] == single.id[i]) continue;
            differing += packets.id[i] == no_hit_id || single.id[i] == no_hit_id ||
                         !are_in_the_same_place(packets.t[i], single.t[i]);
          }
          // Embree tests a packet's rays by other code than single ones.
          EXPECT_LE(differing, most_differing)
              << how.name() << ", width " << width << ", coherent " << coherent;
        }
      }
    }
  }
}

TEST(embree, counts_ids_of_planes_spheres_and_meshes_as_we_do) {
  Scene scene = load_scene("chair-ball");
  ASSERT_FALSE(scene.meshes.empty());
  scene.meshes.insert(scene.meshes.begin(), scene.meshes.front());  // hides nothing: the same again, far off
  for (Vec3f& vertex : scene.meshes.front().vertices) vertex += Vec3f(1000, 0, 0);
  const Oracle all = oracle_of(scene);
  EmbreeScene embree({"avx2", false, false});
  embree.build(scene);
  EXPECT_EQ(embree.first_triangle(), all.primitives().first_triangle());
  const RayBatch rays = batch_of(make_rays<float>(scene, all, "primary", ray_count));
  const HitBatch hits = trace(embree, rays, false, 1, true);
  size_t of_triangles = 0, differing = 0;
  for (size_t i = 0; i < rays.size; ++i) {
    const auto hit = all.closest(rays.ray(i));
    if (!hit || hit->id < all.primitives().first_triangle()) continue;
    of_triangles++;
    differing += hits.id[i] != hit->id;
  }
  EXPECT_GT(of_triangles, ray_count / 50);
  EXPECT_LE(differing, most_differing);
}

TEST(embree, holds_memory_that_is_counted) {
  const Scene scene = triangles_of("chair-ball");
  EmbreeScene embree({"avx2", false, false});
  EXPECT_LT(embree.bytes(), 1000u);
  embree.build(scene);
  const size_t once = embree.bytes();
  EXPECT_GT(once, scene.triangle_count() * 3 * sizeof(uint32_t)) << "its indices alone";
  embree.build(scene);
  EXPECT_LT(embree.bytes(), once * 3 / 2) << "the first one is kept";
}

TEST(embree, is_never_handed_a_ray_that_ends_it) {
  const float nan = std::nanf(""), inf = std::numeric_limits<float>::infinity();
  const Ray<float> good{{0, 0, 0}, {0, 0, 1}};
  const std::pair<Ray<float>, float> bad[] = {{{{nan, 0, 0}, {0, 0, 1}}, inf},
                                              {{{0, inf, 0}, {0, 0, 1}}, inf},
                                              {{{0, 0, 0}, {0, nan, 1}}, inf},
                                              {{{0, 0, 0}, {0, 0, -inf}}, 1},
                                              {{{2e18f, 0, 0}, {0, 0, 1}}, 1},
                                              {good, nan},
                                              {good, -1}};
  for (const int width : {1, 4, 8, 16}) {
    for (const auto& [ray, t_max] : bad) {
      RayBatch rays(2);
      rays.set(0, good);
      rays.set(1, ray, t_max);
      EXPECT_THROW(make_embree_rays(width)->prepare(rays, false), std::invalid_argument);
    }
  }
}

TEST(embree, leaves_denormals_as_they_were) {
  volatile float tiny = std::numeric_limits<float>::denorm_min();
  {
    const FlushDenormals flush;
#ifdef __SSE__
    EXPECT_EQ(tiny * 1.0f, 0.0f);
#endif
  }
  EXPECT_GT(tiny * 1.0f, 0.0f);
}

TEST(embree, forgets_at_a_reset_what_the_last_run_found) {
  const Scene scene = triangles_of("chair-ball");
  const Oracle core = oracle_of(scene);
  EmbreeScene embree({"avx2", false, false});
  embree.build(scene);
  for (const bool any_hit : {false, true}) {
    const RayBatch rays =
        any_hit ? batch_of(make_rays<float>(scene, core, "shadow", 100)) : nearest_rays(scene, core, 100);
    const auto packets = make_embree_rays(8);
    packets->prepare(rays, any_hit);
    packets->trace(embree, true);
    const auto found = [&] {
      const HitBatch hits = packets->hits(embree);
      return std::ranges::count_if(hits.id, [](uint32_t id) { return id != no_hit_id; });
    };
    EXPECT_GT(found(), 0);
    packets->reset();
    EXPECT_EQ(found(), 0);
    const HitBatch hits = packets->hits(embree);
    for (size_t i = 0; i < rays.size; ++i) EXPECT_EQ(hits.t[i], rays.t_max[i]);
  }
}

TEST(embree, traces_no_rays_at_all) {
  const Scene scene = triangles_of("chair-ball");
  EmbreeScene embree({"avx2", false, false});
  embree.build(scene);
  for (const int width : {1, 16}) EXPECT_NO_THROW(trace(embree, RayBatch(0), true, width, true));
}

}  // namespace
}  // namespace raysweep
