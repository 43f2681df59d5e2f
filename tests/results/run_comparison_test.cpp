#include "results/run_comparison.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/results/make_record.h"
#include "tests/results/statistics/simulated.h"

namespace raysweep {
namespace {

struct Cell {
  std::string scheduler;
  int threads;
  double fps;
  std::string hash = "right";
};

/// Seven launches of each cell with 0.2 % of noise.
RunData run_of(const std::vector<Cell>& cells, int rounds = 7, uint64_t skip = 0) {
  Simulated draw("normal");
  for (uint64_t i = 0; i < skip; ++i) (void)draw();
  RunData run;
  std::vector<Record> planned;
  for (int round = 0; round < rounds; ++round) {
    for (const Cell& cell : cells) {
      Record r = make_record(cell.scheduler, cell.threads, round, std::exp(0.1 * draw()) / cell.fps);
      r.image_hash = cell.hash;
      run.records.push_back(r);
      if (round == 0) planned.push_back(r);
    }
  }
  run.context = {"test", "title", {0.005, 7}};
  run.rows = summarise(run.records, planned, 0.5);
  return run;
}

const std::vector<Cell> before{{"serial", 1, 1}, {"thread_static", 2, 1.5}, {"thread_dynamic", 2, 2}};

TEST(run_comparison, equal_runs_show_no_difference) {
  const auto made = compare_runs(run_of(before), run_of(before, 7, 1000));
  EXPECT_EQ(made.sentence, "B is faster in 0 of 3 cells, slower in 0, no difference shown in 3");
  EXPECT_FALSE(made.slower_than(0));
  ASSERT_EQ(made.warnings.size(), 1u);
  EXPECT_NE(made.warnings[0].find("measured one after the other"), std::string::npos);
  EXPECT_EQ(made.unanswered(), "");
}

TEST(run_comparison, a_processor_that_ran_at_another_speed_is_told) {
  auto a = run_of(before), b = run_of(before, 7, 1000);
  for (Record& r : a.records) r.state.spin_before_seconds = 1e-3;
  for (Record& r : b.records) r.state.spin_before_seconds = 1.04e-3;
  const auto made = compare_runs(a, b);
  ASSERT_EQ(made.warnings.size(), 2u);
  EXPECT_NE(made.warnings[1].find("the calibrated spin took +4.0 % in B"), std::string::npos)
      << made.warnings[1];
  for (Record& r : b.records) r.state.spin_before_seconds = 1.01e-3;
  EXPECT_EQ(compare_runs(a, b).warnings.size(), 1u);
}

TEST(run_comparison, a_cell_of_a_that_cannot_be_compared_leaves_the_question_open) {
  auto fewer = before;
  fewer.pop_back();
  EXPECT_NE(compare_runs(run_of(before), run_of(fewer, 7, 1000)).unanswered().find("only in A"),
            std::string::npos);
  EXPECT_EQ(compare_runs(run_of(fewer), run_of(before, 7, 1000)).unanswered(), "") << "B may have more";
  EXPECT_NE(compare_runs(run_of(before), run_of(before, 5, 1000)).unanswered().find("fewer than 6 launches"),
            std::string::npos);
}

TEST(run_comparison, finds_what_became_faster_or_slower_and_names_the_worst) {
  auto after = before;
  after[0].fps *= 1.1;
  after[1].fps *= 0.96;
  const auto made = compare_runs(run_of(before), run_of(after, 7, 1000));
  EXPECT_TRUE(made.sentence.starts_with("B is faster in 1 of 3 cells, slower in 1 (worst −4."))
      << made.sentence;
  EXPECT_TRUE(made.sentence.ends_with("]: thread_static, 2 threads), no difference shown in 1"))
      << made.sentence;
  EXPECT_TRUE(made.slower_than(0.03));
  EXPECT_FALSE(made.slower_than(0.05)) << "slower by less";
  EXPECT_LT(*made.rows[1].adjusted_p, 0.05);
}

TEST(run_comparison, runs_of_old_schemas_have_the_same_cells) {
  auto old = run_of(before);
  for (Record& r : old.records) r.environment = r.wait_policy = r.spin_count = "-";
  for (CellRow& row : old.rows) row.cell.environment = row.cell.wait_policy = row.cell.spin_count = "-";
  EXPECT_EQ(compare_runs(old, run_of(before, 7, 1000)).unanswered(), "");
}

TEST(run_comparison, matches_cells_by_their_factors_and_tells_which_are_alone) {
  const std::vector<Cell> other{{"thread_static", 4, 2}, {"thread_static", 2, 1.5}, {"serial", 1, 1}};
  const auto made = compare_runs(run_of(before), run_of(other, 7, 1000));
  ASSERT_EQ(made.rows.size(), 4u);
  EXPECT_TRUE(made.rows[0].change);
  EXPECT_TRUE(made.rows[1].change);
  EXPECT_EQ(made.rows[2].not_compared, "only in A");
  EXPECT_EQ(made.rows[3].not_compared, "only in B");
  EXPECT_EQ(made.rows[3].name, "thread_static, 4 threads");
  EXPECT_EQ(made.sentence,
            "B is faster in 0 of 2 cells, slower in 0, no difference shown in 2; not compared: 2");
}

TEST(run_comparison, other_pictures_are_no_comparison) {
  auto after = before;
  after[1].fps = 0.5;
  after[1].hash = "other";
  const auto made = compare_runs(run_of(before), run_of(after, 7, 1000));
  EXPECT_EQ(made.rows[1].not_compared, "not comparable: they rendered different pictures");
  EXPECT_FALSE(made.slower_than(0));
}

TEST(run_comparison, another_machine_is_a_warning) {
  RunData elsewhere = run_of(before, 7, 1000);
  for (CellRow& row : elsewhere.rows) row.cell.machine.cpu = "faster";
  const auto made = compare_runs(run_of(before), elsewhere);
  ASSERT_EQ(made.warnings.size(), 1u);
  EXPECT_EQ(made.warnings[0],
            "the runs were made on different machines: A on host (cpu, 4 processors), B on host (faster, 4 "
            "processors)");
  EXPECT_NE(comparison_table(made).caption.find("different machines"), std::string::npos);
}

TEST(run_comparison, the_floor_is_the_larger_and_unknown_where_either_is) {
  auto after = before;
  for (Cell& cell : after) cell.fps *= 0.98;
  RunData a = run_of(before), b = run_of(after, 7, 1000);
  EXPECT_TRUE(compare_runs(a, b).slower_than(0.01));
  b.context.floor.log_ratio = 0.03;
  EXPECT_FALSE(compare_runs(a, b).slower_than(0.01)) << "below the floor of B";
  EXPECT_FALSE(compare_runs(b, a).slower_than(0.01));
  b.context.floor = {};
  EXPECT_TRUE(compare_runs(a, b).sentence.ends_with("; noise floor unknown"));
}

TEST(run_comparison, few_launches_are_told) {
  EXPECT_EQ(compare_runs(run_of(before, 5), run_of(before)).sentence,
            "B is faster in 0 of 3 cells, slower in 0, no difference shown in 0, too few launches in 3");
  EXPECT_EQ(compare_runs(run_of({}), run_of({})).sentence, "no cell can be compared");
}

TEST(cell_comparison, is_paired_by_round) {
  RunData run = run_of(before);
  for (CellRow& row : run.rows) {
    for (auto& [round, fps] : row.fps_by_round) fps *= 1 + 0.3 * round;  // drift must cancel
  }
  const auto made = compare_cells(run, run.rows[2], run.rows[1]);
  EXPECT_TRUE(
      made.sentence.starts_with("thread_static, 2 threads is slower than thread_dynamic, 2 threads by 25"))
      << made.sentence;
  EXPECT_TRUE(made.slower_than(0.2));
  EXPECT_FALSE(compare_cells(run, run.rows[1], run.rows[2]).slower_than(0));
}

TEST(run_comparison, has_tables_for_people_and_programs) {
  const auto made = compare_runs(run_of(before), run_of({before[0], before[1]}, 7, 1000));
  const Table table = comparison_table(made), data = comparison_data(made);
  EXPECT_EQ(table.rows[2].back(), "only in A");
  EXPECT_EQ(table.rows[0].back(), "no difference shown");
  for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
  for (const auto& row : data.rows) EXPECT_EQ(row.size(), data.columns.size());
  const auto json = comparison_as_json(made);
  EXPECT_EQ(json["sentence"], made.sentence);
  EXPECT_EQ(json["rows"][0]["verdict"], "no difference");
  EXPECT_EQ(json["noise_floor"], 0.005);
}

}  // namespace
}  // namespace raysweep
