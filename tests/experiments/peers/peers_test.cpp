// A whole comparison, small, with the real Embree where it is.
#include "experiments/peers/peers.h"

#include <gtest/gtest.h>

#include "experiments/errors.h"
#include "tests/experiments/peers/fake_contestant.h"
#include "tests/tracer/edge_rays.h"
#include "tests/tracer/scene_folder.h"
#include "tracer/scene/scenes.h"

namespace raysweep {
namespace {

PeersRequest small_request(const char* scene) {
  PeersRequest request;
  request.scenes = {scene};
  request.width = 64;
  request.height = 48;
  request.duel.rounds = 6;
  request.duel.run_seconds = 1e-4;
  return request;
}

const auto say_nothing = [](const std::string&) {};

TEST(peers, compares_triangles_alone) {
  const Scene scene = triangles_alone(load_scene("chair-ball"));
  EXPECT_TRUE(scene.planes.empty());
  EXPECT_TRUE(scene.spheres.empty());
  EXPECT_EQ(scene.triangle_count(), 10817u);
}

TEST(peers, refuses_a_scene_without_triangles) {
  const EmbreeModule unused;
  for (const BuiltInScene& built_in : built_in_scenes()) {
    const std::string name(built_in.name);
    if (load_scene(name).triangle_count() > 0) continue;
    try {
      (void)compare_with_embree(small_request(name.c_str()), unused, say_nothing);
      ADD_FAILURE() << name << " was accepted";
    } catch (const RequestError& error) {
      EXPECT_EQ(std::string(error.what()).find("scene \"" + name + "\" has no triangles"), 0u)
          << error.what();
    }
  }
}

ForEach alone(int) { return one_after_the_other; }

TEST(peers, our_team_finds_what_the_oracle_finds) {
  const Scene scene = triangles_alone(load_scene("chair-ball"));
  const OracleCore oracle = make_oracle(scene);
  const RobustOracleCore robust_oracle = make_robust_oracle(scene);
  const Team team = make_our_team(scene, alone);
  for (const RayKind kind : {RayKind::primary, RayKind::shadow, RayKind::mirror, RayKind::diffuse}) {
    const RayBatch rays = make_rays(kind, scene, oracle, 64, 48, 1);
    for (const Entrant& entrant : team.entrants) {
      entrant.contestant->prepare(rays, asks_any_hit(kind));
      entrant.contestant->reset();
      entrant.contestant->run();
      const HitBatch hits = entrant.contestant->hits();
      const auto expect_hits_of = [&](const auto& core) {
        for (size_t i = 0; i < rays.size; ++i) {
          if (asks_any_hit(kind)) {
            EXPECT_EQ(hits.id[i] != no_hit_id, core.occluded(rays.ray(i), rays.t_max[i]));
          } else {
            const auto hit = core.closest(rays.ray(i));
            EXPECT_EQ(hits.id[i], hit ? hit->id : no_hit_id);
          }
        }
      };
      entrant.robust ? expect_hits_of(robust_oracle) : expect_hits_of(oracle);
    }
  }
}

TEST(peers, in_our_team_who_is_robust_lets_no_ray_pass_at_an_edge) {
  std::mt19937 random(8);
  const Scene scene = scene_of({rough_sphere(16, 16, random)});
  const Mesh& mesh = scene.meshes[0];
  RayBatch rays(10'000);
  for (size_t i = 0; i < rays.size; ++i) {
    const auto& triangle = mesh.triangles[random() % mesh.triangles.size()];
    rays.set(i, ray_towards<float>({0.1, 0.2, 0.3}, point_on_border(mesh, triangle, random)));
  }
  size_t robust_count = 0;
  const Team team = make_our_team(scene, alone);
  for (const Entrant& entrant : team.entrants) {
    entrant.contestant->prepare(rays, false);
    entrant.contestant->run();
    const HitBatch hits = entrant.contestant->hits();
    const bool leaks = std::ranges::count(std::span(hits.id).first(rays.size), no_hit_id) > 0;
    EXPECT_EQ(leaks, !entrant.robust) << entrant.contestant->name();
    robust_count += entrant.robust;
  }
  EXPECT_EQ(robust_count * 2, team.entrants.size()) << "each instruction set has both";
}

TEST_F(DuelOf, a_row_tells_who_is_faster_and_where_hits_differ) {
  enter(ours, "ours", 1, true, false, 7);
  enter(embree, "embree", 50, true, false, 8);
  const auto row = make_row(run(), DuelClass::single, rays, false);
  ASSERT_TRUE(row.has_value());
  EXPECT_EQ(row->ours, "ours");
  EXPECT_EQ(row->embree, "embree");
  EXPECT_EQ(row->rays, ray_count);
  EXPECT_GT(row->ratio.value, 1);
  ASSERT_TRUE(row->ratio.interval.has_value());
  EXPECT_LE(row->ratio.interval->low, row->ratio.value);
  EXPECT_GE(row->ratio.interval->high, row->ratio.value);
  EXPECT_EQ(row->between.rays, ray_count);
  EXPECT_EQ(row->ours_from_oracle.rays, 0u);
  EXPECT_EQ(row->embree_from_oracle.rays, ray_count);
}

TEST_F(DuelOf, a_class_that_one_of_the_two_has_not_got_has_no_row) {
  enter(ours, "ours", 1, true);
  enter(embree, "robust", 1, false, true);
  for (const DuelClass c : {DuelClass::single, DuelClass::best, DuelClass::robust})
    EXPECT_FALSE(make_row(run(), c, rays, false).has_value());
}

TEST(peers, builds_take_turns_and_the_quickest_of_a_team_counts) {
  std::string turns;
  const auto build = [&](const char* build_class, int threads, char name, double seconds) {
    return TimedBuild{build_class, threads, [&turns, name, seconds] {
                        turns += name;
                        return BuildCost{seconds, 1};
                      }};
  };
  Team ours, embree;
  ours.builds = {build("medium", 2, 'a', 3)};
  embree.builds = {build("medium", 2, 'b', 5), build("medium", 2, 'c', 4), build("medium", 1, 'd', 1)};
  const auto result = compare_builds(ours, embree, "medium", 2);
  ASSERT_TRUE(result.has_value());
  EXPECT_EQ(turns, "abcabcabcabcabcabcabc");
  EXPECT_EQ(result->embree.seconds, 4);
  EXPECT_EQ(result->ratio.value, 0.75);
  EXPECT_FALSE(compare_builds(ours, embree, "medium", 1).has_value()) << "ours has none";
}

#if RAYSWEEP_HAS_EMBREE
TEST(peers, has_a_row_for_every_kind_and_class_and_builds_by_one_and_two_threads) {
  const PeersResult result = compare_with_embree(small_request("chair-ball"), load_embree(), say_nothing);
  EXPECT_EQ(result.rows.size(), 4u * 3) << "single, best and robust";
  for (const PeersRow& row : result.rows) {
    EXPECT_GT(row.ratio.value, 0);
    EXPECT_GT(row.ours_per_second, 0);
    EXPECT_EQ(row.ours_from_oracle.rays, 0u) << "our team promises our oracle's hits";
    EXPECT_LE(row.between.rays, row.rays / 500 + 2) << "Embree may differ at edges";
    EXPECT_TRUE(row.duel_class != DuelClass::single || row.embree.find("medium single") != std::string::npos)
        << row.embree;
    const bool is_robust = row.duel_class == DuelClass::robust;
    EXPECT_EQ(row.ours.find("robust") != std::string::npos, is_robust) << row.ours;
    EXPECT_EQ(row.embree.find("robust") != std::string::npos, is_robust) << row.embree;
  }
  ASSERT_EQ(result.builds.size(), 4u);
  for (const size_t i : {0u, 1u, 2u, 3u}) {
    EXPECT_EQ(result.builds[i].build_class, i < 2 ? "medium" : "high");
    EXPECT_EQ(result.builds[i].threads, i % 2 == 0 ? 1 : 2);
    if (result.builds[i].threads == 1) {
      EXPECT_GT(result.builds[i].embree.bytes, 100'000u);
    }
    EXPECT_GT(result.builds[i].ratio.value, 0);
  }
}

TEST(peers, makes_pictures_in_every_mode_that_is_asked_for_with_one_thread_and_with_two) {
  PeersRequest request = small_request("chair-ball");
  request.kinds = {};
  request.pictures = {.modes = {"low", "hard"}, .scale = 0.1, .rounds = 6, .run_seconds = 1e-4, .seed = 1};
  const PeersResult result = compare_with_embree(request, load_embree(), say_nothing);
  ASSERT_EQ(result.pictures.size(), 4u);
  for (size_t i = 0; i < 4; ++i) {
    const PictureRow& row = result.pictures[i];
    EXPECT_EQ(row.mode, i < 2 ? "low" : "hard");
    EXPECT_EQ(row.threads, i % 2 == 0 ? 1 : 2);
    EXPECT_EQ(row.width, i < 2 ? 51 : 102) << "a tenth, rounded";
    EXPECT_GT(row.ours_per_second, 0);
    EXPECT_LE(row.ratio.interval->low, row.ratio.value);
    EXPECT_GT(row.embree_share, 0);
    EXPECT_LT(row.embree_share, 1);
    EXPECT_LE(row.differences.pixels, 5u) << "Embree may differ at edges";
  }
}

TEST(peers, leaves_pictures_of_glass_out_and_says_so) {
  PeersRequest request = small_request("cornell-glass");
  request.kinds = {};
  request.pictures.modes = {"low"};
  const PeersResult result = compare_with_embree(request, load_embree(), say_nothing);
  EXPECT_TRUE(result.pictures.empty());
  ASSERT_EQ(result.left_out.size(), 1u);
  EXPECT_NE(result.left_out[0].find("cornell-glass: no pictures: it holds glass"), std::string::npos);
}

using peers_files = SceneFolder;

/// Two triangles in opposite corners: the middle of the picture is empty.
TEST_F(peers_files, leaves_a_kind_without_rays_out_and_says_so) {
  if (!why_no_mesh_files().empty()) GTEST_SKIP() << why_no_mesh_files();
  const std::string file =
      write("corners.obj",
            "v -1 -1 0\nv -0.9 -1 0\nv -1 -0.9 0\nv 1 1 0\nv 0.9 1 0\nv 1 0.9 0\nf 1 2 3\nf 4 5 6\n");
  PeersRequest request = small_request(file.c_str());
  request.width = request.height = 1;
  const PeersResult result = compare_with_embree(request, load_embree(), say_nothing);
  ASSERT_EQ(result.left_out.size(), 3u) << "all but primary";
  for (const std::string& sentence : result.left_out)
    EXPECT_NE(sentence.find("nothing to start them at"), std::string::npos);
  EXPECT_EQ(result.rows.size(), 3u);
}
#endif

}  // namespace
}  // namespace raysweep
