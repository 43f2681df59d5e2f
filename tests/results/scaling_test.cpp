#include "results/scaling.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "results/tables/tables.h"
#include "tests/results/make_record.h"

namespace raysweep {
namespace {

/// Seven rounds in which the machine gets slower and slower: ratios within a round stay what they are.
std::vector<Record> drifting_run() {
  std::vector<Record> records;
  for (int round = 0; round < 7; ++round) {
    const double slow = 1 + 0.1 * round;
    records.push_back(make_record("serial", 1, round, 1.0 * slow));
    records.push_back(make_record("omp_static", 1, round, 1.25 * slow));
    records.push_back(make_record("omp_static", 2, round, 0.625 * slow));
    records.push_back(make_record("omp_static", 8, round, 0.5 * slow));
    records.push_back(make_record("serial", 1, round, 1.25 * slow, 2));
    records.push_back(make_record("serial", 1, round, 2.0 * slow, 4));
  }
  return records;
}

/// The cells of that run, as planned.
std::vector<Record> planned_cells() {
  std::vector<Record> cells;
  for (const Record& r : drifting_run()) {
    if (r.round > 0) break;
    cells.push_back(r);
    cells.back().frame_seconds.clear();
  }
  std::swap(cells[4], cells[3]);  // a co-run cell among the others
  return cells;
}
const std::vector<Record> order = planned_cells();

TEST(scaling, speedups_name_their_base_and_are_paired_within_rounds) {
  const auto rows = summarise(drifting_run(), order, 0.5);
  ASSERT_EQ(rows.size(), 4u) << "co-run cells serve others";
  const CellRow& two = rows[2];
  EXPECT_NEAR(two.speedup->value, 1.6, 1e-12);
  EXPECT_NEAR(two.speedup->interval->low, 1.6, 1e-12) << "drift must cancel";
  EXPECT_NEAR(two.speedup->interval->high, 1.6, 1e-12);
  EXPECT_NEAR(two.speedup_one->value, 2, 1e-12);
  EXPECT_NEAR(*two.efficiency, 0.8, 1e-12);
  EXPECT_NEAR(*two.core_efficiency, 0.8, 1e-12);
}

TEST(scaling, the_ceiling_is_what_co_running_processes_reach) {
  const auto rows = summarise(drifting_run(), order, 0.5);
  EXPECT_NEAR(rows[2].ceiling->value, 1.6, 1e-12);
  EXPECT_NEAR(rows[2].of_ceiling->value, 1.0, 1e-12);
  EXPECT_FALSE(rows[1].ceiling) << "one thread has no ceiling to speak of";
}

TEST(scaling, more_threads_than_processors_are_oversubscribed_and_share_the_cores) {
  const auto rows = summarise(drifting_run(), order, 0.5);
  EXPECT_FALSE(rows[2].oversubscribed);
  const CellRow& eight = rows[3];
  EXPECT_TRUE(eight.oversubscribed);
  EXPECT_NEAR(eight.speedup->value, 2, 1e-12);
  EXPECT_NEAR(*eight.efficiency, 0.25, 1e-12);
  EXPECT_NEAR(*eight.core_efficiency, 1, 1e-12) << "two cores";
  EXPECT_NEAR(eight.ceiling->value, 2, 1e-12) << "of four processes, one a processor";
  EXPECT_EQ(eight.notes.front(), "oversubscribed");
}

TEST(scaling, bound_threads_fill_the_cores_of_their_processors) {
  const auto core_efficiency = [](const std::string& pin, int cores_seen) {
    auto records = drifting_run();
    auto cells = order;
    for (auto* list : {&records, &cells}) {
      for (Record& r : *list) {
        r.pin = r.scheduler == "serial" ? "-" : pin;
        if (r.frame_seconds.empty()) continue;
        r.cores_seen = cores_seen;
      }
    }
    return *summarise(records, cells, 0.5)[2].core_efficiency;
  };
  EXPECT_NEAR(core_efficiency("0-1", 1), 1.6, 1e-12) << "two threads on one core";
  EXPECT_NEAR(core_efficiency("none", 1), 0.8, 1e-12) << "where they happened to run does not count";
  EXPECT_NEAR(core_efficiency("0-1", 0), 0.8, 1e-12) << "unknown";
}

TEST(scaling, few_launches_and_wide_intervals_are_noted) {
  std::vector<Record> records;
  for (int round = 0; round < 5; ++round) records.push_back(make_record("serial", 1, round, 1));
  EXPECT_EQ(summarise(records, order, 0.02)[0].notes.back(), "no interval: fewer than 6 launches");
  for (int round = 5; round < 9; ++round)
    records.push_back(make_record("serial", 1, round, round % 2 ? 1.2 : 0.8));
  const std::string note = summarise(records, order, 0.02)[0].notes.back();
  EXPECT_TRUE(note.starts_with("not converged: ±")) << note;
}

TEST(scaling, void_launches_count_for_nothing_and_are_told) {
  auto records = drifting_run();
  records[2].valid = false;
  records[2].reason = "picture differs";
  const auto rows = summarise(records, order, 0.5);
  EXPECT_EQ(rows[2].fps->count, 6);
  EXPECT_EQ(rows[2].notes.front(), "1 of 7 launches void: picture differs");
  for (Record& r : records) {
    if (r.scheduler == "omp_static") r.valid = false;
  }
  const auto none = summarise(records, order, 0.5);
  EXPECT_FALSE(none[2].fps) << "a void cell stays a row, without numbers";
}

TEST(scaling, cells_that_were_not_launched_stay_as_rows_with_the_reason) {
  auto records = drifting_run();
  std::erase_if(records, [](const Record& r) { return r.threads == 8; });
  const auto rows = summarise(records, order, 0.5);
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[3].cell.threads, 8);
  EXPECT_EQ(rows[3].notes.front(), "not measured: the run ended before its first launch");
  EXPECT_EQ(scaling_table(rows, {"test", "title"}).rows.size(), 4u);
}

TEST(scaling, fewer_threads_than_asked_are_told) {
  auto records = drifting_run();
  records[2].threads_seen = 1;
  EXPECT_EQ(summarise(records, order, 0.5)[2].notes.front(), "1 of 2 threads ran");
}

TEST(scaling, more_threads_than_a_quota_allows_are_told) {
  auto records = drifting_run();
  for (Record& r : records) r.machine.quota = 1.5;
  const auto rows = summarise(records, order, 0.5);
  EXPECT_EQ(rows[2].notes.front(), "more threads than the control group's quota of 1.5 processors");
  for (const std::string& note : rows[1].notes)
    EXPECT_EQ(note.find("quota"), std::string::npos) << "one thread fits";
}

TEST(scaling, the_tax_of_a_scheduler_is_how_much_longer_one_thread_takes_than_none) {
  const auto rows = summarise(drifting_run(), order, 0.5);
  const Table data = scaling_data(rows);
  const auto column =
      std::ranges::find(data.columns, "scheduler_tax", &Table::Column::title) - data.columns.begin();
  const auto tax = [&](size_t row) { return data.rows[row][static_cast<size_t>(column)]; };
  EXPECT_EQ(tax(0), "") << "serial is what it is measured by";
  EXPECT_NEAR(std::stod(tax(1)), 0.25, 1e-12);
  EXPECT_EQ(tax(2), "") << "two threads";
}

TEST(scaling, threads_bound_to_fewer_processors_are_oversubscribed_and_have_no_ceiling) {
  auto records = drifting_run();
  for (Record& r : records) {
    if (r.threads < 2) continue;
    r.pin = "one_core";
    r.processors_seen = r.cores_seen = 1;
  }
  auto cells = order;
  for (Record& r : cells) {
    if (r.threads >= 2) r.pin = "one_core";
  }
  const auto rows = summarise(records, cells, 0.5);
  EXPECT_TRUE(rows[2].oversubscribed) << "two threads on one of four processors";
  EXPECT_FALSE(rows[2].ceiling) << "co-running processes had them all";
}

TEST(scaling, items_that_share_cache_lines_are_marked_where_several_threads_write_them) {
  auto records = drifting_run(), cells = order;
  for (Record& r : records) r.shares_cache_lines = true;
  const auto rows = summarise(records, cells, 0.5);
  const auto marked = [](const CellRow& row) {
    return std::ranges::find(row.notes, "items share cache lines") != row.notes.end();
  };
  for (const CellRow& row : rows) EXPECT_EQ(marked(row), row.cell.threads > 1);
}

/// 1/1.6 of the fps at the end, along a line through the medians.
const std::string drifts = "drifts by −47.3 % over the run: the interval is too narrow for what comes later";

TEST(tables, show_what_varies_and_mark_what_is_oversubscribed) {
  const Table table = scaling_table(summarise(drifting_run(), order, 0.5), {"test", "title"});
  EXPECT_EQ(table.columns[0].title, "scheduler");
  EXPECT_EQ(table.columns[1].title, "threads") << "chunk has one value only, and serial none";
  EXPECT_NE(table.caption.find("scene scene · mode hard"), std::string::npos) << table.caption;
  EXPECT_EQ(table.rows.size(), 4u);
  EXPECT_EQ(table.rows[3].back(), "oversubscribed; " + drifts);
}

TEST(tables, modes_become_columns_as_in_the_published_tables) {
  auto records = drifting_run();
  const size_t count = records.size();
  for (size_t i = 0; i < count; ++i) {
    Record r = records[i];
    r.mode = "low";
    r.cell += "low";
    r.frame_seconds = {{r.frame_seconds[0][0] / 10}};
    records.push_back(r);
  }
  auto both = order;
  for (Record cell : order) {
    cell.mode = "low";
    cell.cell += "low";
    both.push_back(cell);
  }
  const auto tables = mode_tables(summarise(records, both, 0.5));
  const auto fps = std::ranges::find(tables, "fps-omp_static", &ModeTable::name);
  ASSERT_NE(fps, tables.end());
  const std::string both_drift = "hard " + drifts + "; low " + drifts;
  EXPECT_EQ(to_csv(fps->table), "threads,hard,low,notes\n1,0.615,6.154," + both_drift + "\n2,1.231,12.31," +
                                    both_drift + "\n8,1.538,15.38,oversubscribed; " + both_drift + "\n");
  EXPECT_TRUE(mode_tables(summarise(drifting_run(), order, 0.5)).empty()) << "one mode needs no such table";
}

}  // namespace
}  // namespace raysweep
