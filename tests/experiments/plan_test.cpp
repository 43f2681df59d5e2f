#include "experiments/plan.h"

#include <fmt/format.h>
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
  EXPECT_EQ(plan.cells.size(), 6u) << "and a twin";
  EXPECT_TRUE(has(plan, "serial", 1));
  EXPECT_TRUE(has(plan, "thread_static", 1));
  EXPECT_TRUE(has(plan, "serial", 1, 2)) << "the ceiling of two processors serves two and four threads";
  for (const PlannedCell& p : plan.cells)
    EXPECT_EQ(p.asked, p.cell.scheduler == "thread_static" && p.cell.threads > 1 && p.cell.twin == 0)
        << p.key;
}

TEST(plan, without_bases_it_holds_what_is_asked_for_and_a_twin) {
  const Plan plan =
      plan_of("[sweep]\nscheduler = \"thread_static\"\nthreads = [2, 4]\n[measure]\nbases = false\n");
  EXPECT_EQ(plan.cells.size(), 3u);
  for (const PlannedCell& p : plan.cells) EXPECT_EQ(p.cell.scheduler, "thread_static") << p.key;
}

TEST(plan, the_twin_is_of_the_cell_that_fills_the_machine) {
  const Plan plan =
      plan_of("[sweep]\nscheduler = [\"thread_static\", \"thread_cyclic\"]\nthreads = [4, 1, 2]\n");
  const auto twin = std::ranges::find_if(plan.cells, [](const PlannedCell& p) { return p.cell.twin > 0; });
  ASSERT_NE(twin, plan.cells.end());
  EXPECT_EQ(twin->cell.scheduler, "thread_static");
  EXPECT_EQ(twin->cell.threads, 2);
  EXPECT_FALSE(twin->asked);
  for (const PlannedCell& p : plan.cells)
    EXPECT_EQ(std::ranges::count(p.bases, twin->key), p.key + ",twin=1" == twin->key);
}

TEST(plan, a_slowed_cell_comes_with_its_original_and_twins_are_of_that) {
  const Plan plan = plan_of("[sweep]\nscheduler = \"thread_static\"\nthreads = 2\nslowdown = [0.5, 0]\n");
  std::string original;
  for (const PlannedCell& p : plan.cells) {
    if (p.cell.twin > 0) {
      EXPECT_EQ(p.cell.slowdown, 0);
    } else if (p.cell.threads == 2 && p.cell.slowdown == 0) {
      original = p.key;
    }
  }
  const auto slowed =
      std::ranges::find_if(plan.cells, [](const PlannedCell& p) { return p.cell.slowdown > 0; });
  ASSERT_NE(slowed, plan.cells.end());
  EXPECT_EQ(std::ranges::count(slowed->bases, original), 1);
}

TEST(plan, there_may_be_more_twins_or_none) {
  const auto twins = [](int asked) {
    const Plan plan = plan_of(fmt::format("[sweep]\nthreads = 2\n[measure]\ntwins = {}\n", asked));
    return std::ranges::count_if(plan.cells, [](const PlannedCell& p) { return p.cell.twin > 0; });
  };
  for (const int asked : {0, 1, 3}) EXPECT_EQ(twins(asked), asked);
}

TEST(plan, cells_keep_their_turns_whichever_others_take_part) {
  const Plan all = plan_of("[sweep]\nscheduler = \"thread_cyclic\"\nthreads = [1, 2]\nchunk = [1, 2, 3]\n"),
             some = plan_of("[sweep]\nscheduler = \"thread_cyclic\"\nthreads = 2\nchunk = [1, 3]\n");
  const auto keys = [](const Plan& plan) {
    std::vector<std::string> list;
    for (const size_t index : plan.order(3)) list.push_back(plan.cells[index].key);
    return list;
  };
  const auto of_some = keys(some);
  auto of_all = keys(all);
  std::erase_if(of_all,
                [&](const std::string& key) { return std::ranges::find(of_some, key) == of_some.end(); });
  ASSERT_GT(of_all.size(), 3u);
  std::vector<std::string> shared = of_some;
  std::erase_if(shared,
                [&](const std::string& key) { return std::ranges::find(of_all, key) == of_all.end(); });
  EXPECT_EQ(of_all, shared);
}

TEST(plan, factors_that_a_scheduler_ignores_make_one_cell) {
  EXPECT_EQ(plan_of("[sweep]\nscheduler = \"serial\"\nthreads = [1, 2, 3]\nchunk = [1, 2]\n").cells.size(),
            2u)
      << "and its twin";
}

TEST(plan, a_swept_value_wins_over_the_mode) {
  const Plan plan = plan_of("[scene]\nmodes = [\"low\", \"hard\"]\n[sweep]\ndepth = 9\n");
  ASSERT_EQ(plan.cells.size(), 3u);
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
