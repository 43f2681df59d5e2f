#include "results/best.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "results/tables/tables.h"
#include "tests/results/make_record.h"
#include "tests/results/statistics/simulated.h"

namespace raysweep {
namespace {

/// Cells of two threads with these fps; a little noise that differs from round to round, or from cell to
/// cell.
std::vector<CellRow> rows_of(const std::vector<std::pair<std::string, double>>& cells, int rounds = 7,
                             double noise = 0.001) {
  Simulated draw("normal");
  std::vector<Record> records, planned;
  for (int round = 0; round < rounds; ++round) {
    for (const auto& [scheduler, fps] : cells)
      records.push_back(make_record(scheduler, 2, round, std::exp(draw() * noise / 0.02) / fps));
  }
  for (const Record& r : records) {
    if (r.round == 0) planned.push_back(r);
  }
  return summarise(records, planned, 0.5);
}

std::vector<std::string> column(const Table& table, const std::string& title) {
  const auto found = std::ranges::find(table.columns, title, &Table::Column::title);
  std::vector<std::string> cells;
  if (found == table.columns.end()) return cells;
  for (const auto& row : table.rows)
    cells.push_back(row.at(static_cast<size_t>(found - table.columns.begin())));
  return cells;
}

std::vector<std::string> standings(const std::vector<CellRow>& rows, const NoiseFloor& floor = {}) {
  return column(scaling_table(rows, {"test", "title", floor}), "against the best");
}

TEST(best, is_the_fastest_where_all_others_are_shown_to_be_slower) {
  const auto said = standings(rows_of({{"omp_static", 9}, {"omp_dynamic", 10}}));
  ASSERT_EQ(said.size(), 2u);
  EXPECT_TRUE(said[0].starts_with("slower by 9.9 % [9.")) << said[0];
  EXPECT_EQ(said[1], "fastest");
}

TEST(best, has_but_the_best_median_where_another_may_be_as_fast) {
  const auto said = standings(rows_of({{"omp_static", 9}, {"omp_dynamic", 10}, {"tbb_auto", 10.0001}}));
  EXPECT_TRUE(said[0].starts_with("slower by ")) << said[0];
  EXPECT_EQ(std::ranges::count(said, "best median"), 1);
  EXPECT_EQ(std::ranges::count(said, "no difference shown"), 1);
}

TEST(best, what_is_below_the_noise_floor_is_no_difference) {
  const auto rows = rows_of({{"omp_static", 9.8}, {"omp_dynamic", 10}});
  EXPECT_TRUE(standings(rows)[0].starts_with("slower by"));
  EXPECT_EQ(standings(rows, {0.03, 7}), (std::vector<std::string>{"no difference shown", "best median"}));
}

TEST(best, needs_six_rounds_and_a_second_cell) {
  EXPECT_EQ(standings(rows_of({{"omp_static", 9}, {"omp_dynamic", 10}}, 5)),
            (std::vector<std::string>{"too few launches", "best median"}));
  EXPECT_TRUE(standings(rows_of({{"omp_static", 9}})).empty()) << "no column";
}

TEST(best, compares_only_the_same_picture_and_number_of_threads) {
  auto rows = rows_of({{"omp_static", 9}, {"omp_dynamic", 10}, {"tbb_auto", 11}});
  rows[1].cell.threads = 4;
  rows[2].cell.mode = "low";
  EXPECT_EQ(against_the_best(rows, {}).comparisons, 0u);
  rows[1].cell.threads = 2;
  rows[1].cell.chunk = "7";
  EXPECT_EQ(against_the_best(rows, {}).comparisons, 1u);
}

TEST(best, of_equal_cells_is_shown_at_most_5_times_of_100) {
  int found = 0;
  constexpr int trials = 1000;
  auto rows = rows_of({{"a", 1}, {"b", 1}, {"c", 1}, {"d", 1}, {"e", 1}, {"f", 1}});
  Simulated draw("normal");
  for (int trial = 0; trial < trials; ++trial) {
    for (CellRow& row : rows) {
      std::vector<double> fps;
      for (auto& [round, value] : row.fps_by_round) fps.push_back(value = std::exp(draw()));
      row.fps = estimate_median(fps);
    }
    const auto placed = against_the_best(rows, {});
    found += std::ranges::any_of(placed.rows, [](const Standing& s) { return s.verdict == Verdict::slower; });
  }
  RecordProperty("found", std::to_string(found / double(trials)));
  EXPECT_LE(found, trials * 0.05 + 2.5 * std::sqrt(trials * 0.05 * 0.95));
}

/// One cell had converged when the machine became slower; the other was launched on.
TEST(best, is_chosen_by_the_rounds_that_all_share) {
  auto rows = rows_of({{"converged", 9.7}, {"launched_on", 10}});
  for (int round = 7; round < 28; ++round) rows[1].fps_by_round[round] = 8 + 0.001 * round;
  rows[1].fps->value = 8;
  const auto placed = against_the_best(rows, {});
  EXPECT_EQ(placed.rows[1].place, Standing::Place::best);
  EXPECT_EQ(placed.rows[0].place, Standing::Place::other);
}

TEST(best, has_its_numbers_in_the_data_too) {
  const auto rows = rows_of({{"omp_static", 9}, {"omp_dynamic", 10}, {"serial", 1}});
  const Table data = scaling_data(rows);
  EXPECT_EQ(column(data, "against_best_verdict"), (std::vector<std::string>{"slower", "fastest", "slower"}));
  EXPECT_NEAR(std::stod(column(data, "against_best")[0]), 0.9, 0.005);
  EXPECT_LT(std::stod(column(data, "against_best_high")[0]), 1);
  EXPECT_LT(std::stod(column(data, "against_best_p")[0]), 0.05);
  for (const auto& row : data.rows) EXPECT_EQ(row.size(), data.columns.size());
}

TEST(tables, name_the_noise_floor_and_the_number_of_comparisons) {
  const auto caption = [](const std::vector<CellRow>& rows, const NoiseFloor& floor) {
    const std::string all = scaling_table(rows, {"test", "title", floor}).caption;
    return all.substr(all.rfind('\n') + 1);
  };
  const auto rows = rows_of({{"a", 9}, {"b", 10}, {"c", 11}});
  EXPECT_EQ(caption(rows, {}),
            "noise floor unknown: no A/A pairs; against the best of as many threads: fps paired by round, "
            "corrected for "
            "all comparisons among them (up to 3)");
  EXPECT_EQ(caption({rows[0]}, {std::log(1.008), 7}), "noise floor: 0.8 % (A/A of 7 pairs)");
}

}  // namespace
}  // namespace raysweep
