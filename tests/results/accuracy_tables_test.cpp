// What tables say of records that are made up.
#include "results/tables/accuracy_tables.h"

#include <gtest/gtest.h>

#include "tests/results/accuracy_records.h"

namespace raysweep {
namespace {

std::vector<std::string> titles(const Table& table) {
  std::vector<std::string> list;
  for (const auto& column : table.columns) list.push_back(column.title);
  return list;
}

const Table& named(const std::vector<NamedTable>& tables, const std::string& name) {
  for (const NamedTable& one : tables) {
    if (one.name == name) return one.table;
  }
  ADD_FAILURE() << "no table " << name;
  return tables.front().table;
}

using Row = std::vector<std::string>;

TEST(accuracy_tables, no_failure_is_told_by_what_it_may_hide) {
  EXPECT_EQ(per_million({0, 10'000}), "≤ 300");
  EXPECT_EQ(per_million({0, 1'000'000}), "≤ 3.00");
  EXPECT_EQ(per_million({0, 2}), "≤ 1000000") << "a share is at most 1";
  EXPECT_EQ(per_million({3, 400}), "7500");
  EXPECT_EQ(per_million({1, 60'000}), "16.7");
  EXPECT_EQ(per_million({0, 0}), "–");
}

TEST(accuracy_tables, failures_are_shares_of_what_could_fail) {
  AccuracyRecord r = made_up("a", "C", 0);
  r.boundary = 100, r.false_misses = 2, r.false_hits = 5;
  r.mesh_rays = 1000, r.uncovered = 200, r.missed_rays = 8;
  EXPECT_EQ(false_misses(r).of, 400u);
  EXPECT_EQ(false_hits(r).of, 500u);
  EXPECT_EQ(missed_rays(r).of, 800u);
  const auto tables = failure_tables(AccuracyResults({r}));
  EXPECT_EQ(named(tables, "false-misses-float").rows, (std::vector<Row>{{"a", "5000"}}));
  EXPECT_EQ(named(tables, "false-hits-float").rows, (std::vector<Row>{{"a", "10000"}}));
  EXPECT_EQ(named(tables, "missed-rays-float").rows, (std::vector<Row>{{"a", "10000"}}));
}

TEST(accuracy_tables, each_case_stands_at_its_hardest_difficulty_with_hits) {
  AccuracyRecord hard = made_up("a", "C", 1), without = made_up("a", "C", 2);
  hard.false_misses = 4;
  without.hits = 0;
  const auto tables =
      failure_tables(AccuracyResults({made_up("a", "C", 0), hard, without, made_up("b", "D", 0)}));
  const Table& misses = named(tables, "false-misses-float");
  EXPECT_EQ(titles(misses), (Row{"method", "C: 0.1", "D: 1"}));
  EXPECT_EQ(misses.rows, (std::vector<Row>{{"a", "10000", "–"}, {"b", "–", "≤ 7500"}}));
  EXPECT_EQ(titles(named(tables, "false-hits-float")), (Row{"method", "C: 0.01", "D: 1"}))
      << "without hits there are misses";
  for (const NamedTable& one : tables) EXPECT_NE(one.name, "missed-rays-float") << "no case has a mesh";
}

TEST(accuracy_tables, a_method_fails_from_its_first_failure_of_any_kind_on) {
  std::vector<AccuracyRecord> records;
  for (const char* method : {"misses", "hits", "leaks", "poisoned", "good"}) {
    for (const int level : {0, 1}) records.push_back(made_up(method, "C", level));
  }
  records[1].false_misses = records[2].false_hits = records[5].missed_rays = records[7].nonfinite = 1;
  const auto tables = where_failing_tables(AccuracyResults(records));
  EXPECT_EQ(named(tables, "where-failing-float").rows,
            (std::vector<Row>{
                {"misses", "0.1"}, {"hits", "1"}, {"leaks", "0.1"}, {"poisoned", "0.1"}, {"good", "never"}}));
}

TEST(accuracy_tables, variants_do_not_count_where_base_variants_are_told) {
  AccuracyRecord late = made_up("a", "C", 0, "division=late");
  late.false_misses = 400;
  const AccuracyResults results({made_up("a", "C", 0), late});
  EXPECT_EQ(where_failing_tables(results).front().table.rows, (std::vector<Row>{{"a", "never"}}));
  EXPECT_EQ(failure_tables(results).front().table.rows, (std::vector<Row>{{"a", "≤ 7500"}}));
}

TEST(accuracy_tables, a_case_is_told_by_difficulty_and_method_in_each_precision) {
  AccuracyRecord in_double = made_up("a", "C", 0), hard = made_up("b", "C", 1);
  in_double.precision = "double";
  in_double.t_error = no_errors();
  hard.false_misses = 40;
  const auto tables = case_tables(AccuracyResults({made_up("a", "C", 0), in_double, hard}));
  ASSERT_EQ(tables.size(), 1u);
  EXPECT_EQ(tables[0].name, "case-C");
  EXPECT_EQ(tables[0].table.rows,
            (std::vector<Row>{{"1", "a", "≤ 7500", "≤ 5000", "–", "2", "≤ 7500", "≤ 5000", "–", "–"},
                              {"0.1", "b", "100000", "≤ 5000", "–", "2", "–", "–", "–", "–"}}));
}

TEST(accuracy_tables, a_variant_is_told_where_it_differs_from_its_base) {
  AccuracyRecord worse = made_up("a", "D", 1, "reciprocal=newton");
  worse.false_misses = 3;
  worse.t_error.p99 = 6;
  const AccuracyResults results({made_up("a", "C", 0), made_up("a", "C", 0, "early_out=no"),
                                 made_up("a", "C", 0, "reciprocal=newton"), made_up("a", "D", 1), worse,
                                 made_up("b", "C", 0, "division=late")});
  const auto sums = variant_table(results), cells = differing_cells_table(results);
  ASSERT_TRUE(sums && cells);
  EXPECT_EQ(sums->rows, (std::vector<Row>{{"a", "reciprocal=newton", "float", "2", "1", "0 → 3", "0", "0",
                                           "0", "3 × at D: 0.1"}}));
  EXPECT_EQ(cells->rows, (std::vector<Row>{{"a", "reciprocal=newton", "float", "D", "0.1", "0 → 3", "0", "0",
                                            "0", "2 → 6", "2e-07 → 2e-07"}}));
  EXPECT_FALSE(variant_table(AccuracyResults({made_up("a", "C", 0)})));
}

TEST(accuracy_tables, a_variant_that_is_asked_for_less_does_not_differ_by_that) {
  AccuracyRecord hit_only = made_up("a", "C", 0, "output=hit"), base = made_up("a", "C", 0);
  hit_only.variant.output = "hit";
  hit_only.t_error = hit_only.uv_error = no_errors();
  base.nonfinite = 5;
  EXPECT_TRUE(variant_table(AccuracyResults({base, hit_only}))->rows.empty());
}

TEST(accuracy_tables, data_have_a_row_for_each_record_with_every_digit) {
  AccuracyRecord r = made_up("a", "C", 0);
  r.t_error.max = 0.1 + 0.2;
  const Table table = accuracy_data(AccuracyResults({r}));
  ASSERT_EQ(table.rows.size(), 1u);
  ASSERT_EQ(table.rows[0].size(), table.columns.size());
  const std::string csv = to_csv(table);
  EXPECT_NE(csv.find(",0.30000000000000004,"), std::string::npos) << csv;
}

}  // namespace
}  // namespace raysweep
