#include "experiments/plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace raysweep {
namespace {

Plan plan_of(const std::string& sweep) {
  return make_plan(parse_config("experiment = \"x\"\n" + sweep, "x.toml", {}, {2, 2}), {2, 2});
}

bool has(const Plan& plan, const std::string& scheduler, int threads, int processes = 1) {
  return std::ranges::any_of(plan.cells, [&](const PlannedCell& p) {
    return p.cell.scheduler == scheduler && p.cell.threads == threads && p.cell.processes == processes;
  });
}

TEST(plan, adds_the_bases_that_its_tables_compare_with) {
  const Plan plan = plan_of("[sweep]\nscheduler = \"thread_static\"\nthreads = [2, 4]\n");
  EXPECT_EQ(plan.cells.size(), 5u);
  EXPECT_TRUE(has(plan, "serial", 1));
  EXPECT_TRUE(has(plan, "thread_static", 1));
  EXPECT_TRUE(has(plan, "serial", 1, 2)) << "the ceiling of two processors serves two and four threads";
  for (const PlannedCell& p : plan.cells)
    EXPECT_EQ(p.asked, p.cell.scheduler == "thread_static" && p.cell.threads > 1) << p.key;
}

TEST(plan, factors_that_a_scheduler_ignores_make_one_cell) {
  EXPECT_EQ(plan_of("[sweep]\nscheduler = \"serial\"\nthreads = [1, 2, 3]\nchunk = [1, 2]\n").cells.size(),
            1u);
}

TEST(plan, a_swept_value_wins_over_the_mode) {
  const Plan plan = plan_of("[scene]\nmodes = [\"low\", \"hard\"]\n[sweep]\ndepth = 9\n");
  ASSERT_EQ(plan.cells.size(), 2u);
  for (const PlannedCell& p : plan.cells) EXPECT_EQ(p.cell.settings.depth, 9);
  EXPECT_EQ(plan.cells[1].cell.settings.width, 1024);
}

TEST(plan, each_round_has_every_cell_once_in_its_own_order_given_by_the_seed) {
  Plan plan = plan_of("[sweep]\nscheduler = \"thread_cyclic\"\nthreads = [1, 2]\nchunk = [1, 2, 3, 4, 5]\n");
  std::set<std::vector<size_t>> orders;
  for (int round = 0; round < 7; ++round) {
    auto order = plan.order(round);
    EXPECT_EQ(order, plan.order(round));
    orders.insert(order);
    std::ranges::sort(order);
    for (size_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], i);
  }
  EXPECT_EQ(orders.size(), 7u);
  const auto first = plan.order(0);
  plan.seed = 2;
  EXPECT_NE(plan.order(0), first);
}

}  // namespace
}  // namespace raysweep
