// Each rule on made-up numbers, measured and printed, by the same code.
#include "results/claims/judge.h"

#include <gtest/gtest.h>

#include "results/claims/groups.h"
#include "tests/results/claims/made_up.h"

namespace raysweep {
namespace {

constexpr MachineCounts machine{6, 12};

Claim claim_of(Rule rule) {
  Claim claim;
  claim.id = "id";
  claim.rule = rule;
  claim.quantity = "fps";
  if (rule != Rule::ratio) claim.key = "threads";
  return claim;
}

Claim ratio_claim(const std::string& low, const std::string& high) {
  Claim claim = claim_of(Rule::ratio);
  claim.of = {{"threads", "12"}};
  claim.to = {{"threads", "6"}};
  claim.expect[""] = {low, high};
  return claim;
}

struct Side {
  const char* name;
  Make make;
};

/// Both kinds of numbers go through every test below.
class judged : public testing::TestWithParam<Side> {
 protected:
  static ClaimVerdict verdict(const Claim& claim, const std::vector<std::pair<int, double>>& values) {
    return judge(claim, by_threads(GetParam().make, values), machine).verdict;
  }
};

INSTANTIATE_TEST_SUITE_P(sides, judged,
                         testing::Values(Side{"measured", measured_usually}, Side{"printed", printed}),
                         [](const auto& side) { return side.param.name; });

TEST_P(judged, a_ratio_holds_inside_its_range_and_fails_outside) {
  EXPECT_EQ(verdict(ratio_claim("1.2", "1.3"), {{6, 4}, {12, 5}}), ClaimVerdict::holds);
  EXPECT_EQ(verdict(ratio_claim("1.2", "1.3"), {{6, 4}, {12, 6}}), ClaimVerdict::fails);
  EXPECT_EQ(verdict(ratio_claim("1.2", "1.3"), {{6, 4}, {12, 4}}), ClaimVerdict::fails);
  EXPECT_EQ(verdict(ratio_claim("", "1.3"), {{6, 4}, {12, 4}}), ClaimVerdict::holds);
}

TEST_P(judged, a_ratio_at_the_edge_of_its_range_is_undecided) {
  const SideJudgement side =
      judge(ratio_claim("1.25", "1.3"), by_threads(GetParam().make, {{6, 4}, {12, 5}}), machine);
  EXPECT_EQ(side.verdict, ClaimVerdict::untold);
  EXPECT_TRUE(side.is_undecided);
  EXPECT_NE(side.sentence.find("undecided: its interval reaches across the edge"), std::string::npos)
      << side.sentence;
}

TEST_P(judged, a_value_is_judged_by_itself_one_in_a_group) {
  Claim claim = claim_of(Rule::value);
  claim.key = "";
  claim.expect[""] = {"3.5", "pus / 2"};
  EXPECT_EQ(verdict(claim, {{6, 4}, {12, 5.5}}), ClaimVerdict::holds);
  EXPECT_EQ(verdict(claim, {{6, 4}, {12, 1}}), ClaimVerdict::fails) << "each thread count is a group";
  claim.has_for_each = true;
  EXPECT_EQ(verdict(claim, {{6, 4}, {12, 5.5}}), ClaimVerdict::untold) << "two numbers in one group";
}

TEST_P(judged, the_peak_is_where_it_is_expected_or_as_good_as_there) {
  Claim claim = claim_of(Rule::argmax);
  claim.expected_values = {"pus"};
  EXPECT_EQ(verdict(claim, {{6, 4}, {12, 5}, {13, 4.5}}), ClaimVerdict::holds);
  EXPECT_EQ(verdict(claim, {{6, 4}, {12, 5}, {13, 6}}), ClaimVerdict::fails);
  EXPECT_EQ(verdict(claim, {{6, 5}, {12, 5}}), ClaimVerdict::untold);
  claim.within = 0.1;
  EXPECT_EQ(verdict(claim, {{6, 5}, {12, 5}}), ClaimVerdict::holds);
  claim.expected_values = {"6", "13"};
  EXPECT_EQ(verdict(claim, {{6, 4}, {12, 5}, {13, 6}}), ClaimVerdict::holds) << "any of them";
}

TEST_P(judged, the_smallest_is_where_it_is_expected) {
  Claim claim = claim_of(Rule::argmin);
  claim.expected_values = {"6"};
  EXPECT_EQ(verdict(claim, {{6, 4}, {12, 5}}), ClaimVerdict::holds);
  EXPECT_EQ(verdict(claim, {{6, 5}, {12, 4}}), ClaimVerdict::fails);
  EXPECT_EQ(verdict(claim, {{6, 4}, {12, 4}}), ClaimVerdict::untold);
}

TEST_P(judged, a_plateau_is_flat_over_its_range_whatever_is_beside_it) {
  Claim claim = claim_of(Rule::plateau);
  claim.over = {"3", "7"};
  EXPECT_EQ(verdict(claim, {{1, 9}, {3, 5}, {5, 5.05}, {7, 4.98}, {8, 1}}), ClaimVerdict::holds);
  EXPECT_EQ(verdict(claim, {{3, 5}, {5, 6}, {7, 5}}), ClaimVerdict::fails);
  EXPECT_EQ(verdict(claim, {{3, 5}, {7, 5.25}}), ClaimVerdict::untold);
  claim.over.clear();
  claim.values = {"1", "8"};
  claim.expect[""] = {"8", "12"};
  EXPECT_EQ(verdict(claim, {{1, 10}, {3, 5}, {8, 1}}), ClaimVerdict::holds)
      << "ten times between the largest and the smallest";
}

TEST_P(judged, a_step_is_against_the_value_before_or_the_one_that_is_named) {
  Claim claim = claim_of(Rule::step);
  claim.at = "8";
  claim.expect[""] = {"1.9", "2.1"};
  EXPECT_EQ(verdict(claim, {{6, 1}, {7, 2}, {8, 4}}), ClaimVerdict::holds);
  EXPECT_EQ(verdict(claim, {{6, 2}, {7, 4}, {8, 4}}), ClaimVerdict::fails);
  claim.from = "6";
  EXPECT_EQ(verdict(claim, {{6, 2}, {7, 4}, {8, 4}}), ClaimVerdict::holds);
  EXPECT_EQ(verdict(claim, {{7, 4}, {8, 4}}), ClaimVerdict::untold);
}

TEST_P(judged, a_line_goes_through_the_origin_unless_it_may_miss_it) {
  Claim claim = claim_of(Rule::linear);
  EXPECT_EQ(verdict(claim, {{1, 2}, {2, 4}, {6, 12}}), ClaimVerdict::holds);
  EXPECT_EQ(verdict(claim, {{1, 2}, {2, 3}, {6, 7}}), ClaimVerdict::fails);
  claim.intercept = true;
  EXPECT_EQ(verdict(claim, {{1, 2}, {2, 3}, {6, 7}}), ClaimVerdict::holds);
  claim.intercept = false;
  claim.inverse = true;
  EXPECT_EQ(verdict(claim, {{1, 12}, {2, 6}, {6, 2}}), ClaimVerdict::holds)
      << "time grows by the factor where fps falls by it";
}

TEST_P(judged, an_order_is_kept_by_every_neighbour) {
  Claim claim = claim_of(Rule::order);
  claim.expected_values = {"6", "12", "1"};
  EXPECT_EQ(verdict(claim, {{1, 2}, {6, 8}, {12, 4}}), ClaimVerdict::holds);
  EXPECT_EQ(verdict(claim, {{1, 5}, {6, 8}, {12, 4}}), ClaimVerdict::fails);
  claim.smallest_first = true;
  EXPECT_EQ(verdict(claim, {{1, 8}, {6, 2}, {12, 4}}), ClaimVerdict::holds);
}

TEST_P(judged, values_can_be_relative_to_another_observation_that_where_leaves_out) {
  Claim claim = claim_of(Rule::argmax);
  claim.key = "mode";
  claim.expected_values = {"hard"};
  claim.where["threads"] = {"12"};
  claim.relative_to = {{"threads", "1"}};
  auto list = by_threads(GetParam().make, {{1, 4}, {12, 20}}, "low");
  for (const Observation& one : by_threads(GetParam().make, {{1, 1}, {12, 7}}, "hard")) list.push_back(one);
  EXPECT_EQ(judge(claim, list, machine).verdict, ClaimVerdict::holds) << "7 times is more than 5 times";
  claim.relative_to.clear();
  EXPECT_EQ(judge(claim, list, machine).verdict, ClaimVerdict::fails) << "20 fps are more than 7";
}

TEST_P(judged, every_combination_of_the_other_factors_is_a_group_of_its_own) {
  auto list = by_threads(GetParam().make, {{6, 4}, {12, 5}}, "low");
  for (const Observation& one : by_threads(GetParam().make, {{6, 4}, {12, 8}}, "hard")) list.push_back(one);
  Claim claim = ratio_claim("1.2", "1.3");
  const SideJudgement side = judge(claim, list, machine);
  ASSERT_EQ(side.groups.size(), 2u);
  EXPECT_EQ(side.groups[0].group, (Factors{{"mode", "low"}}));
  EXPECT_EQ(side.groups[0].holds, true);
  EXPECT_EQ(side.groups[1].holds, false);
  EXPECT_EQ(side.verdict, ClaimVerdict::fails);
  for (const char* enough : {"any", "0.5"}) {
    claim.holds = enough;
    EXPECT_EQ(judge(claim, list, machine).verdict, ClaimVerdict::holds) << enough;
  }
  claim.holds = "most";
  EXPECT_EQ(judge(claim, list, machine).verdict, ClaimVerdict::fails) << "one of two is not more than half";
}

TEST_P(judged, groups_may_have_ranges_of_their_own) {
  auto list = by_threads(GetParam().make, {{6, 4}, {12, 5}}, "low");
  for (const Observation& one : by_threads(GetParam().make, {{6, 4}, {12, 8}}, "hard")) list.push_back(one);
  for (const Observation& one : by_threads(GetParam().make, {{6, 4}, {12, 1}}, "other")) list.push_back(one);
  Claim claim = ratio_claim("", "");
  claim.expect = {{"low", {"1.2", "1.3"}}, {"hard", {"1.9", "2.1"}}};
  const SideJudgement side = judge(claim, list, machine);
  EXPECT_EQ(side.verdict, ClaimVerdict::holds);
  EXPECT_EQ(side.groups.size(), 2u) << "nothing is claimed of the third";
}

TEST_P(judged, bounds_and_values_may_be_formulas_of_the_machine) {
  Claim claim = ratio_claim("0.2*cores", "0.5*pus");
  claim.of = {{"threads", "pus"}};
  claim.to = {{"threads", "cores"}};
  const SideJudgement side = judge(claim, by_threads(GetParam().make, {{6, 4}, {12, 8}}), machine);
  EXPECT_EQ(side.verdict, ClaimVerdict::holds);
  ASSERT_EQ(side.groups.size(), 1u);
  EXPECT_DOUBLE_EQ(side.groups[0].low.value(), 0.2 * 6);
  EXPECT_DOUBLE_EQ(side.groups[0].high.value(), 6);
}

TEST(judgement, without_six_rounds_there_is_no_interval_and_nothing_is_decided) {
  std::vector<Observation> list{measured({{"threads", "6"}}, 4, 5), measured({{"threads", "12"}}, 5, 7)};
  const SideJudgement side = judge(ratio_claim("1", "2"), list, machine);
  EXPECT_EQ(side.verdict, ClaimVerdict::untold);
  EXPECT_EQ(side.sentence, "1.25; undecided: fewer than 6 rounds: no interval");
}

TEST(judgement, what_is_exact_is_decided_at_the_edge) {
  std::vector<Observation> list;
  for (const auto& [threads, value] : {std::pair("6", 4.0), std::pair("12", 5.0)}) {
    Observation& made = list.emplace_back(exact_observation(value));
    made.factors["threads"] = threads;
  }
  EXPECT_EQ(judge(ratio_claim("1.25", ""), list, machine).verdict, ClaimVerdict::holds);
  Claim open = ratio_claim("1.25", "");
  open.expect[""].low_open = true;
  EXPECT_EQ(judge(open, list, machine).verdict, ClaimVerdict::fails);
}

TEST(judgement, what_disturbs_all_cells_of_a_round_alike_does_not_widen_a_ratio) {
  std::map<int, double> slow, fast;
  for (int round = 0; round < 9; ++round) {
    slow[round] = 4 * (1 + 0.1 * round);
    fast[round] = 5 * (1 + 0.1 * round);
  }
  std::vector<Observation> list{observation_of(slow), observation_of(fast)};
  list[0].factors["threads"] = "6";
  list[1].factors["threads"] = "12";
  const SideJudgement side = judge(ratio_claim("1.24", "1.26"), list, machine);
  EXPECT_EQ(side.verdict, ClaimVerdict::holds) << side.sentence;
}

TEST(judgement, half_units_of_all_last_digits_add_up) {
  const SideJudgement side = judge(ratio_claim("1", "2"), by_threads(printed, {{6, 4}, {12, 5}}), machine);
  ASSERT_TRUE(side.groups.at(0).interval);
  const double reach = 0.0005 / 4 + (5 / 3.9995 - 1.25);
  EXPECT_NEAR(side.groups[0].interval->low, 1.25 - reach, 1e-12);
  EXPECT_NEAR(side.groups[0].interval->high, 1.25 + reach, 1e-12);
}

TEST(judgement, a_claim_that_is_about_other_machines_is_not_judged) {
  Claim claim = ratio_claim("1", "2");
  claim.applies_when = "cores >= 6 and smt";
  const auto list = by_threads(measured_usually, {{6, 4}, {12, 5}});
  EXPECT_EQ(judge(claim, list, {6, 12}).verdict, ClaimVerdict::holds);
  const SideJudgement side = judge(claim, list, {2, 2});
  EXPECT_EQ(side.verdict, ClaimVerdict::untold);
  EXPECT_EQ(side.sentence, "needs cores >= 6 and smt, where there are 2 cores and 2 processors");
}

TEST(judgement, missing_cells_are_named) {
  EXPECT_EQ(judge(ratio_claim("1", "2"), by_threads(printed, {{6, 4}}), machine).sentence,
            "there is none at threads 12");
  std::vector<Observation> planned = by_threads(measured_usually, {{6, 4}});
  planned.push_back({{{"threads", "12"}, {"mode", "low"}}, {}, {}, false, 0});
  const SideJudgement side = judge(ratio_claim("1", "2"), planned, machine);
  EXPECT_EQ(side.verdict, ClaimVerdict::untold);
  EXPECT_EQ(side.sentence, "threads 12 was not measured");
}

TEST(judgement, two_numbers_where_one_is_asked_for_are_not_mixed) {
  auto list = by_threads(printed, {{6, 4}, {12, 5}}, "low");
  list.push_back(by_threads(printed, {{12, 8}}, "hard").front());
  Claim claim = ratio_claim("1", "3");
  claim.has_for_each = true;
  const SideJudgement side = judge(claim, list, machine);
  EXPECT_EQ(side.verdict, ClaimVerdict::untold);
  EXPECT_NE(
      side.sentence.find("2 numbers are at threads 12, which differ in mode: name that in where or for_each"),
      std::string::npos)
      << side.sentence;
}

TEST(judgement, a_scheduler_that_has_no_use_for_a_factor_is_in_every_group_of_it) {
  std::vector<Observation> list{measured({{"scheduler", "serial"}, {"chunk", "-"}}, 4)};
  for (const char* chunk : {"1", "2"})
    list.push_back(measured({{"scheduler", "omp_dynamic"}, {"chunk", chunk}}, 6));
  Claim claim = ratio_claim("1.4", "1.6");
  claim.of = {{"scheduler", "omp_dynamic"}};
  claim.to = {{"scheduler", "serial"}};
  const SideJudgement side = judge(claim, list, machine);
  EXPECT_EQ(side.verdict, ClaimVerdict::holds) << side.sentence;
  EXPECT_EQ(side.groups.size(), 2u);
  claim.where["chunk"] = {"2"};
  EXPECT_EQ(judge(claim, list, machine).verdict, ClaimVerdict::holds) << "where does not leave it out either";
}

TEST(judgement, what_has_no_use_for_a_factor_is_no_group_beside_those_that_it_is_part_of) {
  const std::vector<Observation> list{measured({{"scheduler", "serial"}, {"chunk", "-"}}, 4),
                                      measured({{"scheduler", "omp_dynamic"}, {"chunk", "1"}}, 6)};
  const auto groups = groups_by({&list[0], &list[1]}, {"chunk"});
  ASSERT_EQ(groups.size(), 1u);
  EXPECT_EQ(groups[0].factors, (Factors{{"chunk", "1"}}));
  EXPECT_EQ(groups[0].members.size(), 2u);
  EXPECT_EQ(groups_by({&list[0]}, {"chunk"}).size(), 1u) << "but alone it is one";
}

TEST(judgement, a_factor_that_others_decide_splits_no_group) {
  std::vector<Observation> list;
  for (const auto& [method, bytes, value] :
       {std::tuple("wald", "48", 4.0), std::tuple("plucker", "36", 6.0)}) {
    for (const char* precision : {"float", "double"})
      list.push_back(measured({{"method", method}, {"bytes", bytes}, {"precision", precision}}, value));
  }
  Claim claim = claim_of(Rule::argmin);
  claim.key = "method";
  claim.expected_values = {"wald"};
  const SideJudgement side = judge(claim, list, machine);
  ASSERT_EQ(side.groups.size(), 2u);
  EXPECT_EQ(side.groups[0].group, (Factors{{"precision", "float"}}));
  EXPECT_EQ(side.verdict, ClaimVerdict::holds);
}

TEST(judgement, verdicts_have_the_words_of_the_study) {
  ClaimSheet sheet;
  sheet.claims = {ratio_claim("1.2", "1.3"), ratio_claim("2", ""), ratio_claim("1.25", ""),
                  ratio_claim("1", "3"), ratio_claim("1", "3")};
  sheet.claims[3].applies_to = AppliesTo::published;
  sheet.claims[4].applies_to = AppliesTo::neither;
  PublishedTable table;
  table.quantity = "fps";
  table.machine = machine;
  table.numbers = {{{{"threads", "6"}}, "4.00"}, {{{"threads", "12"}}, "5.00"}};
  sheet.published = table;
  const Observations ours{{"fps", {measured({{"threads", "6"}}, 4), measured({{"threads", "12"}}, 8)}}};
  const auto judged = judge_all(sheet, ours, machine);
  EXPECT_EQ(judged[0].published_verdict(), "holds in the source");
  EXPECT_EQ(judged[0].our_verdict(), "not reproduced");
  EXPECT_EQ(judged[1].published_verdict(), "contradicted by its own table");
  EXPECT_EQ(judged[2].published_verdict(), "undecided by its digits");
  EXPECT_EQ(judged[2].our_verdict(), "reproduced");
  EXPECT_EQ(judged[3].our_verdict(), "cannot be tested here");
  EXPECT_EQ(judged[4].published_verdict(), "not in a table");
  EXPECT_EQ(judged[4].ours.sentence, "no record tells it");
  sheet.published.reset();
  EXPECT_EQ(judge_all(sheet, ours, machine)[0].published_verdict(), "not in a table");
}

}  // namespace
}  // namespace raysweep
