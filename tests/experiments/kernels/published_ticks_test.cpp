// What Morozov's table 2 says of its own claims, as m11-t2.toml has them.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "experiments/kernel_plan.h"
#include "results/claims/judge.h"
#include "results/claims/measured_cells.h"

namespace raysweep {
namespace {

constexpr MachineCounts machine{4, 8};

ClaimSheet sheet_of_table_2() {
  const std::string file = std::string(RAYSWEEP_SOURCE_DIR) + "/experiments/configs/m11-t2.toml";
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return parse_kernel_config(text.str(), file, {}, 4).claims.sheet;
}

/// With nothing measured, or with `ours`.
ClaimJudgement judged(const std::string& id, const Observations& ours = {}) {
  const auto all = judge_all(sheet_of_table_2(), ours, machine);
  return *std::ranges::find_if(all, [&](const ClaimJudgement& one) { return one.claim.id == id; });
}

const GroupJudgement& group_of(const SideJudgement& side, const Factors& group) {
  return *std::ranges::find(side.groups, group, &GroupJudgement::group);
}

TEST(morozovs_table_2, has_29_times_in_its_sums) {
  const ClaimJudgement claim = judged("sum-29");
  EXPECT_EQ(claim.published_verdict(), "holds in the source");
  ASSERT_EQ(claim.published.groups.size(), 1u);
  EXPECT_NEAR(*claim.published.groups[0].value, 30556219664.0 / 1052283636.0, 1e-9);
}

TEST(morozovs_table_2, contradicts_10_to_34_times_by_its_own_column_of_the_most) {
  const ClaimJudgement claim = judged("ten-to-34.6");
  EXPECT_EQ(claim.published_verdict(), "contradicted by its own table");
  const GroupJudgement& least = group_of(claim.published, {{"statistic", "max"}, {"iterations", "10000000"}});
  EXPECT_NEAR(*least.value, 1.52, 0.005);
  EXPECT_EQ(least.holds, false);
  EXPECT_EQ(group_of(claim.published, {{"statistic", "sum"}, {"iterations", "1000"}}).holds, true);
}

TEST(morozovs_table_2, has_a_least_above_its_mean_in_one_row_alone) {
  const ClaimJudgement claim = judged("min-avg-max");
  EXPECT_EQ(claim.published_verdict(), "contradicted by its own table");
  for (const GroupJudgement& one : claim.published.groups) {
    const bool is_it =
        one.group.at("vector") == "expression_templates" && one.group.at("iterations") == "10000";
    EXPECT_EQ(one.holds, !is_it) << one.group.at("vector") << ' ' << one.group.at("iterations");
  }
}

TEST(morozovs_table_2, is_judged_beside_records_of_ours) {
  std::vector<KernelRecord> records;
  for (const auto& [vector, sum] : {std::pair{"valarray", 290e6}, std::pair{"expression_templates", 10e6}}) {
    for (int round = 0; round < 7; ++round) {
      KernelRecord r;
      r.kernel = "expression_templates";
      r.factors = {{"vector", vector}, {"iterations", "10000000"}};
      r.cell = vector;
      r.round = round;
      r.tests = r.iterations = 1;
      r.seconds = {1};
      r.ticks = {sum / 1e7, sum / 2e6, sum / 1e6, sum};
      records.push_back(r);
    }
  }
  const auto ours = [&] {
    return observations_of(measured_cells(KernelData{"x", "x", 7, 2, {}, KernelResults(records)}));
  };
  EXPECT_EQ(judged("sum-29", ours()).our_verdict(), "reproduced");
  EXPECT_EQ(judged("min-avg-max", ours()).our_verdict(), "reproduced");
  for (KernelRecord& r : records) {
    if (r.factors["vector"] == "valarray") r.ticks->sum /= 3;
  }
  EXPECT_EQ(judged("sum-29", ours()).our_verdict(), "not reproduced");
}

}  // namespace
}  // namespace raysweep
