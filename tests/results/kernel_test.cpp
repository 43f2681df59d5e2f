// What is made of kernels' records, which are made up.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "results/record.h"
#include "results/tables/kernel_tables.h"
#include "results/tables/small_kernel_tables.h"

namespace raysweep {
namespace {

/// 1000 tests, 10 passes a sample: `nanoseconds` a test in each of three samples.
KernelRecord made_up(const std::string& method, const std::string& change, int round, double nanoseconds,
                     double hit_rate = 0.5) {
  KernelRecord r;
  r.experiment = "x";
  r.kernel = "intersection";
  r.method = method;
  r.change = change;
  r.variant = {"early", "exact", "distance_first", "inclusive", "yes", "weights", "bare"};
  r.precision = "float";
  r.layout = "aos";
  r.contraction = "off";
  r.compiler = "gcc 12.2.0";
  r.isa = "scalar";
  r.bytes = 48;
  r.protocol = "hit-rate";
  r.parameter = hit_rate;
  r.round = round;
  r.tests = 1000;
  r.iterations = 10;
  r.seconds.assign(3, nanoseconds * 1e-9 * 1000 * 10);
  r.cell = method + '/' + change + "/float/hit-rate/" + std::to_string(hit_rate);
  return r;
}

std::vector<KernelRecord> rounds(const std::string& method, const std::string& change,
                                 const std::vector<double>& nanoseconds, double hit_rate = 0.5) {
  std::vector<KernelRecord> records;
  for (const double each : nanoseconds)
    records.push_back(made_up(method, change, static_cast<int>(records.size()), each, hit_rate));
  return records;
}

std::vector<KernelRecord> joined(const std::vector<std::vector<KernelRecord>>& lists) {
  std::vector<KernelRecord> all;
  for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

using Row = std::vector<std::string>;

TEST(kernel_record, is_read_back_as_it_was_written) {
  KernelRecord record = made_up("wald", "rays=8", 3, 2);
  record.scene = "grotto";
  record.valid = false;
  record.reason = "why";
  record.threads = 2;
  record.scheduler = "tbb_auto";
  record.clock = "wall";
  const KernelRecord back = kernel_record_from_json(nlohmann::json::parse(to_line(record)));
  EXPECT_EQ(to_line(back), to_line(record));
  EXPECT_EQ(back.seconds, record.seconds);
  EXPECT_EQ(back.round, 3);
  EXPECT_EQ(back.reason, "why");
  EXPECT_EQ(back.scheduler, "tbb_auto");
  EXPECT_EQ(back.clock, "wall");
}

TEST(kernel_record, a_protocol_without_a_parameter_has_null_there) {
  KernelRecord record = made_up("wald", "base", 0, 2);
  record.parameter = std::nan("");
  const auto json = nlohmann::json::parse(to_line(record));
  EXPECT_TRUE(json.at("parameter").is_null());
  EXPECT_TRUE(std::isnan(kernel_record_from_json(json).parameter));
}

TEST(kernel_record, of_schemas_1_and_2_is_still_read) {
  nlohmann::json json = to_json(made_up("wald", "base", 4, 2));
  json.erase("scheduler");
  json.erase("clock");
  json["schema"] = 2;
  EXPECT_EQ(kernel_record_from_json(json).clock, "") << "it was not told";
  json["schema"] = 1;
  const KernelRecord record = kernel_record_from_json(json);
  EXPECT_EQ(record.method, "wald");
  EXPECT_EQ(record.variant.division, "early");
  EXPECT_EQ(record.round, 4);
}

/// 1000 operations, 10 passes a sample, of a kernel with factors.
KernelRecord small(const std::string& vector, const std::string& iterations, int round, double nanoseconds) {
  KernelRecord r;
  r.experiment = "x";
  r.kernel = "expression_templates";
  r.factors = {{"vector", vector}, {"iterations", iterations}};
  r.cell = "expression_templates/" + vector + '/' + iterations;
  r.compiler = "gcc 12.2.0";
  r.isa = "baseline";
  r.round = round;
  r.tests = 1000;
  r.iterations = 10;
  r.seconds.assign(3, nanoseconds * 1e-9 * 1000 * 10);
  r.ticks = {nanoseconds, 2 * nanoseconds, 50 * nanoseconds, 2000 * nanoseconds};
  return r;
}

std::vector<KernelRecord> small_rounds(const std::string& vector, const std::string& iterations,
                                       const std::vector<double>& nanoseconds) {
  std::vector<KernelRecord> records;
  for (const double each : nanoseconds)
    records.push_back(small(vector, iterations, static_cast<int>(records.size()), each));
  return records;
}

TEST(kernel_record, of_other_kernels_has_their_factors_and_ticks_and_nothing_of_rays) {
  KernelRecord record = small("eigen", "1000", 2, 3);
  const auto json = nlohmann::json::parse(to_line(record));
  EXPECT_EQ(json.at("variant"), (nlohmann::json{{"vector", "eigen"}, {"iterations", "1000"}}));
  EXPECT_EQ(json.at("ticks").at("max"), 150);
  EXPECT_FALSE(json.contains("method"));
  const KernelRecord back = kernel_record_from_json(json);
  EXPECT_EQ(back.factors, record.factors);
  EXPECT_EQ(back.ticks, record.ticks);
  EXPECT_EQ(to_line(back), to_line(record));
  record.ticks.reset();
  EXPECT_FALSE(kernel_record_from_json(to_json(record)).ticks);
}

TEST(kernel_record, others_are_refused) {
  nlohmann::json json = to_json(made_up("wald", "base", 0, 2));
  json["schema"] = 4;
  EXPECT_THROW(static_cast<void>(kernel_record_from_json(json)), RecordError);
  json["schema"] = 2;
  json["kind"] = "accuracy";
  EXPECT_THROW(static_cast<void>(kernel_record_from_json(json)), RecordError);
}

TEST(kernel_results, a_round_counts_by_the_median_of_its_samples) {
  KernelRecord record = made_up("a", "base", 0, 2);
  record.seconds = {9e-5, 2e-5, 3e-5};
  EXPECT_DOUBLE_EQ(nanoseconds_a_test(record), 3);
  const KernelResults results(rounds("a", "base", {5, 1, 2, 8, 3, 4, 100}));
  ASSERT_EQ(results.cells().size(), 1u);
  const Estimate& estimate = *results.cells()[0].nanoseconds;
  EXPECT_NEAR(estimate.value, 4, 1e-9);
  EXPECT_NEAR(estimate.interval->low, 1, 1e-9) << "seven rounds: from the least to the most";
  EXPECT_NEAR(estimate.interval->high, 100, 1e-9);
}

TEST(kernel_results, ratios_are_of_the_same_round) {
  // The machine gets slower and slower; the change always takes half as long again.
  const KernelResults results(
      joined({rounds("a", "base", {1, 2, 3, 4, 5, 6}), rounds("a", "rays=8", {1.5, 3, 4.5, 6, 7.5, 9})}));
  const auto ratio = results.against_base(*results.find("a", "rays=8", "float", "hit-rate 0.5"));
  ASSERT_TRUE(ratio && ratio->estimate.interval);
  EXPECT_NEAR(ratio->estimate.interval->low, 1.5, 1e-9);
  EXPECT_NEAR(ratio->estimate.interval->high, 1.5, 1e-9);
  EXPECT_TRUE(ratio->shows_difference());
  EXPECT_FALSE(results.against_base(*results.find("a", "base", "float", "hit-rate 0.5")));
}

TEST(kernel_results, rounds_that_only_one_has_are_left_out_of_ratios) {
  auto records = rounds("a", "rays=8", {9, 9, 4});
  const auto base = rounds("a", "base", {1, 1, 2});
  records.push_back(base[2]);
  const KernelResults results(records);
  const auto ratio = results.against_base(*results.find("a", "rays=8", "float", "hit-rate 0.5"));
  ASSERT_TRUE(ratio);
  EXPECT_NEAR(ratio->estimate.value, 2, 1e-9);
  EXPECT_EQ(ratio->estimate.count, 1);
  EXPECT_FALSE(ratio->shows_difference()) << "one round has no interval";
}

TEST(kernel_results, records_that_are_not_valid_are_counted_and_not_timed) {
  auto records = rounds("a", "base", {1, 2});
  records[1].valid = false;
  records[1].reason = "3 hits too many";
  const KernelResults results(records);
  EXPECT_EQ(results.cells()[0].by_round.size(), 1u);
  const auto table = void_table(results);
  ASSERT_TRUE(table);
  EXPECT_EQ(table->rows, (std::vector<Row>{{records[0].cell, "1", "3 hits too many"}}));
  EXPECT_FALSE(void_table(KernelResults(rounds("a", "base", {1, 2}))));
}

TEST(kernel_tables, speed_is_told_beside_the_best) {
  const auto tables = speed_tables(KernelResults(joined(
      {rounds("a", "base", {4, 4, 4}), rounds("b", "base", {2, 2, 2}), rounds("b", "rays=8", {1, 1, 1})})));
  ASSERT_EQ(tables.size(), 1u);
  EXPECT_EQ(tables[0].name, "speed-float");
  EXPECT_EQ(tables[0].table.rows,
            (std::vector<Row>{{"a", "48", "4.000", "2.000"}, {"b", "48", "2.000", "1.000"}}))
      << "variants do not count";
}

TEST(kernel_tables, hit_rates_have_a_table_of_their_own_where_there_are_three) {
  const auto curve =
      joined({rounds("a", "base", {4}, 0), rounds("a", "base", {5}, 0.5), rounds("a", "base", {6}, 1)});
  EXPECT_TRUE(speed_tables(KernelResults(curve)).empty());
  const auto tables = hit_rate_tables(KernelResults(curve));
  ASSERT_EQ(tables.size(), 1u);
  EXPECT_EQ(tables[0].table.columns.back().title, "hit-rate 1");
  EXPECT_EQ(tables[0].table.rows, (std::vector<Row>{{"a", "48", "4.000", "5.000", "6.000"}}));
  EXPECT_TRUE(hit_rate_tables(KernelResults(rounds("a", "base", {4}))).empty());
}

TEST(kernel_tables, what_a_factor_changes_is_told_only_where_it_shows) {
  const std::vector<double> same(6, 2.0);
  const auto tables = factor_tables(KernelResults(
      joined({rounds("a", "base", same), rounds("a", "division=late", {2.2, 2.2, 2.2, 2.2, 2.2, 2.4}),
              rounds("a", "rays=8", {1.8, 1.9, 2.0, 2.0, 2.1, 2.2}), rounds("b", "rays=8", same),
              rounds("c", "base", {2, 2}), rounds("c", "rays=8", {1, 1})})));
  ASSERT_EQ(tables.size(), 1u);
  EXPECT_EQ(tables[0].name, "factors-float");
  EXPECT_EQ(tables[0].table.rows,
            (std::vector<Row>{{"a", "division=late", "1.100 [1.100, 1.200]"},
                              {"a", "rays=8", "no difference shown: 1.000 [0.900, 1.100]"},
                              {"b", "rays=8", "–"},
                              {"c", "rays=8", "0.500, no interval"}}));
  EXPECT_TRUE(factor_tables(KernelResults(rounds("a", "base", {1}))).empty());
}

TEST(kernel_results, of_other_kernels_are_told_apart_by_their_cell) {
  const KernelResults results(
      joined({small_rounds("eigen", "10", {1, 2, 3}), small_rounds("struct", "10", {4, 5, 6})}));
  ASSERT_EQ(results.cells().size(), 2u);
  EXPECT_FALSE(results.are_intersection());
  EXPECT_TRUE(KernelResults(rounds("a", "base", {1})).are_intersection());
  EXPECT_NEAR(results.cells()[1].nanoseconds->value, 5, 1e-9);
  EXPECT_EQ(results.cells()[1].ticks.at("max"), (std::map<int, double>{{0, 200}, {1, 250}, {2, 300}}));
  EXPECT_TRUE(speed_tables(results).empty());
  EXPECT_TRUE(factor_tables(results).empty());
}

TEST(kernel_tables, of_other_kernels_set_their_ways_side_by_side) {
  const KernelResults results(
      joined({small_rounds("eigen", "10", {4}), small_rounds("eigen", "100", {6}),
              small_rounds("struct", "10", {8}), small_rounds("valarray", "100", {3})}));
  const auto tables = operation_tables(results);
  ASSERT_EQ(tables.size(), 1u);
  EXPECT_EQ(tables[0].name, "expression_templates");
  EXPECT_EQ(tables[0].table.columns[1].title, "eigen");
  EXPECT_EQ(tables[0].table.rows, (std::vector<Row>{{"10", "4.000", "1.000", "8.000", "2.000", "–", "–"},
                                                    {"100", "6.000", "2.000", "–", "–", "3.000", "1.000"}}));
  EXPECT_TRUE(operation_tables(KernelResults(rounds("a", "base", {1}))).empty());
}

TEST(kernel_tables, ticks_have_the_four_columns_of_the_paper) {
  const auto tables = tick_tables(KernelResults(small_rounds("eigen", "10", {4, 5, 9})));
  ASSERT_EQ(tables.size(), 1u);
  EXPECT_EQ(tables[0].name, "expression_templates-ticks");
  EXPECT_EQ(tables[0].table.rows, (std::vector<Row>{{"10", "eigen", "5.000", "10.00", "250.0", "10000"}}));
  auto records = small_rounds("eigen", "10", {4});
  records[0].ticks.reset();
  EXPECT_TRUE(tick_tables(KernelResults(records)).empty());
}

TEST(kernel_tables, data_of_other_kernels_have_a_column_for_each_factor) {
  auto records = small_rounds("eigen", "10", {4});
  records.push_back(small("struct", "10", 0, 5));
  records.back().valid = false;
  const Table table = kernel_data(KernelResults(records));
  ASSERT_EQ(table.rows.size(), 2u);
  for (const Row& row : table.rows) ASSERT_EQ(row.size(), table.columns.size());
  EXPECT_EQ(table.columns[2].title, "iterations");
  EXPECT_EQ(table.columns[3].title, "vector");
  EXPECT_EQ(table.rows[0][3], "eigen");
  EXPECT_EQ(table.rows[1].back(), "") << "void: no ticks";
}

TEST(kernel_tables, data_have_a_row_for_each_cell_with_every_digit) {
  const Table table = kernel_data(KernelResults(joined(
      {rounds("a", "base", std::vector<double>(6, 2)), rounds("a", "rays=8", std::vector<double>(6, 1))})));
  ASSERT_EQ(table.rows.size(), 2u);
  for (const Row& row : table.rows) ASSERT_EQ(row.size(), table.columns.size());
  const auto value = [&](size_t row, const std::string& title) {
    for (size_t i = 0; i < table.columns.size(); ++i)
      if (table.columns[i].title == title) return table.rows[row][i];
    return std::string("no such column");
  };
  EXPECT_EQ(value(0, "ratio_to_base"), "");
  EXPECT_EQ(value(1, "change"), "rays=8");
  EXPECT_EQ(value(1, "rounds"), "6");
  EXPECT_EQ(std::stod(value(1, "ratio_high")), 0.5);
  EXPECT_EQ(value(1, "hit_rate"), "0");
}

}  // namespace
}  // namespace raysweep
