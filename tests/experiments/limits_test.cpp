// Batches that are traced to see what rays visit, and how they are timed.
#include <gtest/gtest.h>

#include "experiments/limits/batch_runs.h"
#include "tracer/scene/scenes.h"

namespace raysweep {
namespace {

TEST(limits, each_grouping_is_a_run_and_every_run_traces_the_same_rays_anew) {
  const SceneRuns scene(load_scene("chair-ball"), {std::string(best_isa())});
  const auto primary = scene.runs(RayKind::primary, 32, 24), mirror = scene.runs(RayKind::mirror, 32, 24);
  ASSERT_EQ(primary.size(), 2u);
  EXPECT_NE(primary[0].grouping, primary[1].grouping);
  EXPECT_EQ(primary[0].rays, size_t{32 * 24});
  EXPECT_EQ(primary[1].rays, size_t{32 * 24});
  EXPECT_LT(mirror[0].rays, size_t{32 * 24}) << "the background mirrors nothing";
  for (const BatchRun& run : mirror) {
    const uint64_t nodes = run.trace()[Visited::ray_node];
    EXPECT_EQ(run.trace()[Visited::ray_node], nodes);
    EXPECT_EQ(nodes > 0, counts_visits);
  }
}

TEST(limits, runs_take_turns_in_each_round) {
  std::vector<int> order;
  std::vector<BatchRun> runs;
  for (int i = 0; i < 2; ++i) {
    runs.push_back({"", Grouping::single, 1, [&order, i] {
                      order.push_back(i);
                      return VisitCounts();
                    }});
  }
  EXPECT_EQ(cpu_seconds(runs, 3, 0).size(), 2u);
  EXPECT_EQ(order, (std::vector{0, 1, 0, 1, 0, 1}));
}

}  // namespace
}  // namespace raysweep
