// Contracts of records that are made up: what is kept of them, and what runs are told.
#include "results/contract.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "results/record.h"
#include "results/tables/contract_tables.h"
#include "tests/results/accuracy_records.h"

namespace raysweep {
namespace {

/// Two levels of one case; at the second one `misses` false misses.
std::vector<AccuracyRecord> two_levels(uint64_t misses, const std::string& change = "base") {
  AccuracyRecord hard = made_up("a", "C", 1, change);
  hard.false_misses = misses;
  return {made_up("a", "C", 0, change), hard};
}

Contract contract_of(std::vector<AccuracyRecord> records) {
  return Contract(AccuracyResults(std::move(records)));
}

/// A contract by way of its file.
Contract read_text(const std::string& text) {
  const auto file = std::filesystem::temp_directory_path() /
                    ("contract_test_" +
                     std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".csv");
  std::ofstream(file) << text;
  struct Remover {
    std::filesystem::path file;
    ~Remover() { std::filesystem::remove(file); }
  } remover{file};
  return Contract::read(file);
}

Outcome outcome_of(const AccuracyRecord& record, const Contract& contract, std::string_view what) {
  for (const Judgement& one : judge(record, *contract.clause_of(record))) {
    if (one.what == what) return one.outcome;
  }
  ADD_FAILURE() << "nothing is said of " << what;
  return Outcome::kept;
}

TEST(contracts, state_failures_level_by_level_and_say_never_of_none) {
  const std::string text = to_csv(contract_of(two_levels(7)));
  EXPECT_NE(text.find("\na,base,float,C,0,1000,0 7,never,never,never,1 1\n"), std::string::npos) << text;
}

TEST(contracts, are_read_back_as_they_were_written) {
  auto records = two_levels(7);
  for (AccuracyRecord& other : two_levels(8, "division=late")) records.push_back(other);
  records[1].nonfinite = 3;
  records[0].t_error.count = 99;
  const std::string text = to_csv(contract_of(records));
  EXPECT_EQ(to_csv(read_text(text)), text);
}

TEST(contracts, leave_out_variants_that_promise_what_the_base_does) {
  auto records = two_levels(7);
  for (AccuracyRecord& other : two_levels(7, "same")) records.push_back(other);
  for (AccuracyRecord& other : two_levels(8, "worse")) records.push_back(other);
  const Contract contract = contract_of(records);
  ASSERT_EQ(contract.clauses().size(), 2u);
  EXPECT_EQ(contract.clauses()[1].change, "worse");
  EXPECT_EQ(contract.clause_of(two_levels(7, "same")[1]), contract.clauses().data());
  EXPECT_EQ(contract.clause_of(two_levels(7, "worse")[1]), &contract.clauses()[1]);
  EXPECT_EQ(contract.clause_of(made_up("b", "C", 0)), nullptr);
}

TEST(contracts, cannot_be_made_of_cases_with_levels_missing) {
  auto records = two_levels(7);
  records.push_back(made_up("b", "C", 0));
  EXPECT_THROW(contract_of(records), std::invalid_argument);
}

TEST(contracts, of_the_same_rays_are_broken_by_one_failure_more_and_bettered_by_one_less) {
  const Contract contract = contract_of(two_levels(7));
  EXPECT_EQ(outcome_of(two_levels(7)[1], contract, "false_misses"), Outcome::kept);
  EXPECT_EQ(outcome_of(two_levels(8)[1], contract, "false_misses"), Outcome::broken);
  EXPECT_EQ(outcome_of(two_levels(6)[1], contract, "false_misses"), Outcome::better);
}

TEST(contracts, of_other_rays_are_broken_only_beyond_chance_and_twice_the_share) {
  const Contract contract = contract_of(two_levels(100));
  const auto with_misses = [](uint64_t misses, uint64_t rays) {
    AccuracyRecord record = two_levels(misses)[1];
    record.rays = rays;
    return record;
  };
  EXPECT_EQ(outcome_of(with_misses(1900, 10'000), contract, "false_misses"), Outcome::kept) << "not twice";
  EXPECT_EQ(outcome_of(with_misses(2100, 10'000), contract, "false_misses"), Outcome::broken);
  EXPECT_EQ(outcome_of(with_misses(6, 20), contract, "false_misses"), Outcome::kept) << "chance";
  EXPECT_EQ(outcome_of(with_misses(400, 10'000), contract, "false_misses"), Outcome::better);
  EXPECT_EQ(outcome_of(with_misses(600, 10'000), contract, "false_misses"), Outcome::kept) << "not half";
}

TEST(contracts, of_no_failure_bind_other_rays_by_what_they_may_hide) {
  const Contract contract = contract_of(two_levels(0));
  AccuracyRecord record = two_levels(0)[1];
  record.rays = 1001;
  record.false_hits = 12;  // (5/2)²·(1/1000 + 1/1001) of 1001 are 12.5
  EXPECT_EQ(outcome_of(record, contract, "false_hits"), Outcome::kept);
  record.false_hits = 13;
  EXPECT_EQ(outcome_of(record, contract, "false_hits"), Outcome::broken);
}

TEST(contracts, say_nothing_of_another_seed) {
  const Contract contract = contract_of(two_levels(7));
  AccuracyRecord record = two_levels(900)[1];
  record.seed = 9;
  EXPECT_TRUE(judge(record, *contract.clause_of(record)).empty());
}

TEST(contracts, take_the_estimate_of_reciprocals_for_other_rays) {
  const Contract contract = contract_of(two_levels(7));
  AccuracyRecord newton = two_levels(8)[1];
  newton.variant.reciprocal = "newton";
  EXPECT_EQ(outcome_of(newton, contract, "false_misses"), Outcome::kept);
}

TEST(contracts, bound_errors_of_t_by_powers_of_2_from_a_hundred_hits_on) {
  AccuracyRecord record = made_up("a", "C", 0);
  const auto class_of = [&](double p99, uint64_t count) {
    record.t_error.p99 = p99;
    record.t_error.count = count;
    return t_error_class(record);
  };
  EXPECT_EQ(class_of(0, 100), 0);
  EXPECT_EQ(class_of(1, 100), 0);
  EXPECT_EQ(class_of(1.1, 100), 1);
  EXPECT_EQ(class_of(4, 100), 2);
  EXPECT_EQ(class_of(4.1, 100), 3);
  EXPECT_EQ(class_of(4, 99), unstated);
}

TEST(contracts, judge_classes_of_t_exactly_or_for_other_rays_by_two) {
  const Contract contract = contract_of(two_levels(0));
  AccuracyRecord record = two_levels(0)[1];
  record.t_error.p99 = 4;
  EXPECT_EQ(outcome_of(record, contract, "t_error"), Outcome::broken);
  record.rays = 9;
  EXPECT_EQ(outcome_of(record, contract, "t_error"), Outcome::kept);
  record.t_error.p99 = 5;
  EXPECT_EQ(outcome_of(record, contract, "t_error"), Outcome::broken);
}

TEST(contracts, tell_in_a_sentence_where_a_file_is_none) {
  const auto error_of = [](const std::string& text) -> std::string {
    try {
      (void)read_text(text);
    } catch (const RecordError& error) {
      return error.what();
    }
    return "";
  };
  const std::string good = to_csv(contract_of(two_levels(7)));
  EXPECT_NE(error_of("").find("its first line should be method,"), std::string::npos);
  EXPECT_NE(error_of(good + "a,b\n").find(":3: 2 columns where there should be 11"), std::string::npos);
  EXPECT_NE(error_of(good + "a,base,float,D,0,x,never,never,never,never,1\n").find("\"x\" where a number"),
            std::string::npos);
  EXPECT_NE(error_of(good + "a,base,float,D,0,9,1 2,never,never,never,1\n").find("false_misses for 2 levels"),
            std::string::npos);
}

TEST(contract_tables, count_cells_and_list_what_differs) {
  const Contract contract = contract_of(two_levels(7));
  auto records = two_levels(8);
  records[0].t_error.p99 = 1;
  records.push_back(made_up("a", "D", 0));
  const AccuracyResults results(records);
  using Row = std::vector<std::string>;
  EXPECT_EQ(contract_table(results, contract).rows,
            (std::vector<Row>{{"a", "float", "3", "0", "1", "1", "1"}}));
  EXPECT_EQ(contract_differences_table(results, contract).rows,
            (std::vector<Row>{
                {"broken", "a", "base", "float", "C", "0.1", "false_misses", "7 of 1000", "8 of 1000"},
                {"better", "a", "base", "float", "C", "1", "t_error", "≤ 2^1 ε", "≤ 2^0 ε"}}));
}

}  // namespace
}  // namespace raysweep
