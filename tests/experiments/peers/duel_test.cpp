// Who runs when, and who stands for a team. No test asserts how long something takes but where one contestant
// sleeps many times as long as another.
#include "experiments/peers/duel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/experiments/peers/fake_contestant.h"

namespace raysweep {
namespace {

TEST_F(DuelOf, every_round_runs_everyone_who_qualified_once_in_another_order) {
  options.run_seconds = 1e-6;  // no repeats
  enter(ours, "a", 1, true);
  enter(embree, "b", 1, true);
  enter(embree, "c", 1, true);
  enter(embree, "far behind", 60, true);
  const auto all = run();
  EXPECT_TRUE(all.back().rounds.empty());
  const size_t before = 4 * (2 + qualifying_runs);  // to warm up, to know how long it takes, to qualify
  std::set<std::vector<std::string>> orders;
  size_t at = before;
  const auto finalists =
      static_cast<size_t>(std::ranges::count_if(all, [](const Performance& p) { return !p.rounds.empty(); }));
  for (; at + finalists <= log.size(); at += finalists) {
    const auto first = log.begin() + static_cast<std::ptrdiff_t>(at);
    std::vector<std::string> round(first, first + static_cast<std::ptrdiff_t>(finalists));
    orders.insert(round);
    std::ranges::sort(round);
    EXPECT_EQ(std::ranges::adjacent_find(round), round.end()) << "someone ran twice in a round";
  }
  EXPECT_EQ(at, log.size());
  EXPECT_EQ(log.size(), before + finalists * 8);
  EXPECT_TRUE(finalists == 1 || orders.size() > 1) << "always the same order";
}

TEST_F(DuelOf, short_runs_are_repeated) {
  options.run_seconds = 0.05;
  enter(ours, "a", 1, true);
  enter(embree, "b", 200, true);
  (void)run();
  EXPECT_GE(std::ranges::count(log, "a"), 10);
  EXPECT_EQ(std::ranges::count(log, "b"), 2 + qualifying_runs + 8) << "a long run is one sample";
}

TEST_F(DuelOf, the_best_of_a_class_stands_for_its_team) {
  enter(ours, "ours", 1, true);
  enter(embree, "single", 20, true);
  enter(embree, "packet", 1, false);
  enter(embree, "robust", 1, false, true);
  const auto all = run();
  EXPECT_EQ(best_of(all, false, DuelClass::single)->entrant->contestant->name(), "single")
      << "far behind the packets, but the best of its class";
  EXPECT_EQ(best_of(all, false, DuelClass::best)->entrant->contestant->name(), "packet");
  EXPECT_EQ(best_of(all, false, DuelClass::robust)->entrant->contestant->name(), "robust");
  EXPECT_EQ(best_of(all, true, DuelClass::robust), nullptr);
}

TEST_F(DuelOf, who_promises_edges_is_held_against_the_oracle_that_does) {
  enter(ours, "usual", 1, true, false, 7);
  enter(embree, "robust", 1, true, true, 7);
  const auto all = run();
  EXPECT_EQ(all[0].from_oracle.rays, 0u);
  EXPECT_EQ(all[1].from_oracle.rays, ray_count);
}

}  // namespace
}  // namespace raysweep
