// Claims in plan.json.
#include "results/claims/claim_sheet.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "results/record.h"

namespace raysweep {
namespace {

ClaimSheet full_sheet() {
  Claim claim;
  claim.id = "id";
  claim.text = "text";
  claim.source = "source";
  claim.rule = Rule::linear;
  claim.quantity = "fps";
  claim.where = {{"scheduler", {"serial", "omp_static"}}};
  claim.for_each = {"mode"};
  claim.has_for_each = true;
  claim.relative_to = {{"threads", "1"}};
  claim.of = {{"threads", "2"}};
  claim.to = {{"threads", "3"}};
  claim.key = "threads";
  claim.expected_values = {"pus"};
  claim.expect = {{"low", {"1", "2*pus", true, false}}, {"hard", {"", "3", false, true}}};
  claim.over = {"1", "6"};
  claim.values = {"4", "5"};
  claim.at = "7";
  claim.from = "8";
  claim.inverse = claim.intercept = claim.smallest_first = true;
  claim.within = 0.02;
  claim.holds = "most";
  claim.applies_when = "smt";
  claim.applies_to = AppliesTo::published;
  claim.why = "why";
  PublishedTable table{
      "a.csv", "fps", 1e-6, {"threads"}, "first_row", {6, 12}, {{{{"threads", "1"}}, "6.888"}}};
  return {"question?", "raysweep run a.toml", {claim}, table};
}

TEST(claim_sheets, come_back_from_a_plan_as_they_were) {
  nlohmann::json plan;
  const ClaimSheet sheet = full_sheet();
  add_to_plan(plan, sheet);
  const ClaimSheet back = claim_sheet_of(nlohmann::json::parse(plan.dump()));
  EXPECT_EQ(back.question, sheet.question);
  EXPECT_EQ(back.command, sheet.command);
  EXPECT_EQ(back.claims, sheet.claims);
  ASSERT_TRUE(back.published);
  EXPECT_EQ(back.published->file, "a.csv");
  EXPECT_EQ(back.published->scale, 1e-6);
  EXPECT_EQ(back.published->rows, std::vector<std::string>{"threads"});
  EXPECT_EQ(back.published->normalise, "first_row");
  EXPECT_EQ(back.published->machine.pus, 12);
  ASSERT_EQ(back.published->numbers.size(), 1u);
  EXPECT_EQ(back.published->numbers[0].text, "6.888");
  EXPECT_EQ(back.published->numbers[0].factors, (Factors{{"threads", "1"}}));
}

TEST(claim_sheets, an_empty_list_of_groups_is_not_the_usual_one) {
  ClaimSheet sheet;
  sheet.claims.emplace_back().has_for_each = true;
  nlohmann::json plan;
  add_to_plan(plan, sheet);
  EXPECT_TRUE(claim_sheet_of(plan).claims.at(0).has_for_each);
}

TEST(claim_sheets, plans_of_older_runs_have_none) {
  const ClaimSheet sheet = claim_sheet_of({{"experiment", "x"}});
  EXPECT_TRUE(sheet.claims.empty());
  EXPECT_FALSE(sheet.published);
  nlohmann::json plan{{"experiment", "x"}};
  add_to_plan(plan, {});
  EXPECT_EQ(plan.size(), 1u) << "and an experiment without claims has the plan that it had";
}

TEST(claim_sheets, a_rule_of_a_later_program_is_refused) {
  nlohmann::json plan{{"claims", {{{"rule", "sine"}}}}};
  try {
    (void)claim_sheet_of(plan);
    FAIL();
  } catch (const RecordError& error) {
    EXPECT_STREQ(
        error.what(),
        "unknown \"sine\" in a claim; possible: ratio, argmax, argmin, plateau, step, linear, order, value");
  }
}

}  // namespace
}  // namespace raysweep
