#include "results/schedule.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "results/tables/tables.h"
#include "tests/results/make_record.h"

namespace raysweep {
namespace {

/// Two frames of `seconds` each, of which the workers spent these parts in items and after their last one.
Record make_logged(const std::string& scheduler, int round, double seconds, const std::vector<double>& busy,
                   const std::vector<double>& idle) {
  Record r = make_record(scheduler, static_cast<int>(busy.size()), round, seconds);
  r.frame_seconds = {{seconds, seconds}};
  r.log_share = 0.001;
  for (size_t i = 0; i < busy.size(); ++i) {
    WorkerRecord w;
    w.busy_seconds = 2 * seconds * busy[i];
    w.idle_seconds = 2 * seconds * idle[i];
    w.scheduling_seconds = 2 * seconds * (1 - busy[i] - idle[i]);
    w.migrations = 3;
    r.workers.push_back(w);
  }
  return r;
}

/// Items of a frame cost 1 s together and the dearest of them 0.25 s, slowed by what slows the round.
std::vector<Record> slowing_run() {
  std::vector<Record> records;
  for (int round = 0; round < 7; ++round) {
    const double slow = 1 + 0.1 * round;
    records.push_back(make_logged("serial", round, 1.01 * slow, {0.995}, {0.001}));
    records.back().item_seconds = {1.0 * slow, 0.25 * slow};
    records.push_back(make_logged("omp_dynamic", round, 0.625 * slow, {0.9, 0.78}, {0.02, 0.2}));
    Record& two = records.back();
    two.chunk = "4/thread";
    two.chunks_made = {8, 8};
    two.chunk_sizes = {{96, 16}};
    two.empty_region_seconds = 2e-6;
    records.push_back(make_logged("thread_dynamic", round, 0.5 * slow, std::vector<double>(8, 0.5),
                                  std::vector<double>(8, 0.25)));
  }
  return records;
}

/// The rows of these records, in the order of their first round.
std::vector<CellRow> rows_of(const std::vector<Record>& records) {
  std::vector<Record> planned;
  for (const Record& r : records) {
    if (r.round == 0) planned.push_back(r);
  }
  return summarise(records, planned, 0.5);
}

/// What the table says in `column` of `row`; empty if it has no such column.
std::string cell(const std::vector<CellRow>& rows, size_t row, const std::string& column) {
  const auto table = schedule_table(rows);
  if (!table) return "";
  const auto found = std::ranges::find(table->columns, column, &Table::Column::title);
  return found == table->columns.end()
             ? ""
             : table->rows[row][static_cast<size_t>(found - table->columns.begin())];
}

TEST(schedule, quality_is_the_tile_cost_bound_by_the_frame_time_of_the_same_round) {
  const auto rows = rows_of(slowing_run());
  const Estimate quality = *rows[1].schedule.quality;
  EXPECT_NEAR(quality.value, 0.5 / 0.625, 1e-12) << "half of all cost a thread";
  EXPECT_NEAR(quality.interval->low, 0.8, 1e-12) << "drift must cancel";
  EXPECT_NEAR(quality.interval->high, 0.8, 1e-12);
  EXPECT_EQ(cell(rows, 1, "quality"), "80.0 % [80.0, 80.0]");
  EXPECT_EQ(cell(rows, 0, "quality"), "base");
}

TEST(schedule, no_schedule_is_faster_than_its_dearest_item_or_than_the_processors) {
  const auto quality_with = [](double dearest) {
    auto records = slowing_run();
    for (Record& r : records) r.item_seconds.max *= dearest / 0.25;
    return rows_of(records)[2].schedule.quality->value;
  };
  EXPECT_NEAR(quality_with(0.01), 0.25 / 0.5, 1e-12)
      << "eight threads on four processors: a quarter of all cost";
  EXPECT_NEAR(quality_with(0.4), 0.4 / 0.5, 1e-12);
}

TEST(schedule, shares_of_the_threads_time_add_up_to_all_of_it) {
  const auto rows = rows_of(slowing_run());
  for (const CellRow& row : rows) {
    const TimeShares s = *row.schedule.shares;
    EXPECT_NEAR(s.busy + s.scheduling + s.idle, 1, 1e-12);
  }
  EXPECT_NEAR(rows[1].schedule.shares->busy, 0.84, 1e-12);
  EXPECT_NEAR(rows[1].schedule.shares->idle, 0.11, 1e-12);
  EXPECT_EQ(cell(rows, 1, "in scheduler"), "5.0 %");
}

TEST(schedule, shares_are_those_of_one_launch_so_that_an_odd_one_does_not_break_their_sum) {
  auto records = slowing_run();
  records[1].workers[0].busy_seconds /= 2;
  records[4].workers[0].idle_seconds *= 3;
  const TimeShares s = *rows_of(records)[1].schedule.shares;
  EXPECT_NEAR(s.busy, 0.84, 1e-12);
  EXPECT_NEAR(s.busy + s.scheduling + s.idle, 1, 1e-12);
}

TEST(schedule, imbalance_and_inflation_follow_from_the_busy_times) {
  auto records = slowing_run();
  for (Record& r : records) r.imbalance = r.threads == 1 ? 0 : 0.07;
  const auto rows = rows_of(records);
  EXPECT_NEAR(rows[1].schedule.imbalance->value, 0.07, 1e-12) << "as the log has it, frame by frame";
  EXPECT_NEAR(rows[1].schedule.inflation->value, 0.625 * (0.9 + 0.78) - 1, 1e-12)
      << "of one frame, against the serial cost of its items";
  EXPECT_EQ(cell(rows, 1, "inflation"), "5.0 %");
  EXPECT_EQ(cell(rows, 0, "inflation"), "base");
  EXPECT_NEAR(rows[1].schedule.migrations->value, 3, 1e-12) << "six in two frames";
  EXPECT_EQ(cell(rows, 1, "empty region"), "2.000 µs");
}

TEST(schedule, without_a_serial_cost_nothing_is_compared_with_it) {
  auto records = slowing_run();
  for (Record& r : records) r.item_seconds = {};
  const auto rows = rows_of(records);
  EXPECT_FALSE(rows[1].schedule.quality);
  EXPECT_FALSE(rows[1].schedule.inflation);
  EXPECT_EQ(cell(rows, 1, "quality"), "") << "a column of which only the base is known says nothing";
  EXPECT_EQ(cell(rows, 1, "busy"), "84.0 %");
}

TEST(schedule, chunks_are_told_as_asked_and_as_made) {
  auto records = slowing_run();
  const auto text = [&](const std::string& asked, std::vector<uint64_t> made, const ChunkSizes& sizes) {
    for (Record& r : records) {
      if (r.scheduler != "omp_dynamic") continue;
      r.chunk = asked;
      r.chunks_made = made;
      r.chunk_sizes = sizes;
    }
    return cell(rows_of(records), 1, "chunks");
  };
  EXPECT_EQ(text("4/thread", {8, 8}, {{96, 16}}), "4/thread → 8: 96");
  EXPECT_EQ(text("100", {16, 16}, {{67, 16}, {68, 16}}), "100 → 16: 67 to 68");
  EXPECT_EQ(text("1", {7, 9}, {{1, 10}, {24, 12}, {100, 2}, {192, 2}}), "1 → 8: 1–24–192");
  EXPECT_EQ(text("-", {2, 2}, {{384, 4}}), "2: 384") << "nothing to ask for";
  EXPECT_EQ(text("1", {768, 768}, {}), "") << "sizes that nobody logged";
}

TEST(schedule, the_histogram_has_every_factor_and_counts_chunks_of_one_frame) {
  auto records = slowing_run();
  for (Record& r : records) {
    if (r.scheduler == "omp_dynamic") r.chunk_sizes = {{67, 16}, {68, 5}};
  }
  const Table table = chunk_data(rows_of(records));
  ASSERT_EQ(table.rows.size(), 2u);
  const auto last = [](const std::vector<std::string>& row) {
    return std::vector<std::string>(row.end() - 3, row.end());
  };
  EXPECT_EQ(table.columns[table.columns.size() - 3].title, "threads");
  EXPECT_EQ(last(table.rows[0]), (std::vector<std::string>{"2", "67", "8"}));
  EXPECT_EQ(last(table.rows[1]), (std::vector<std::string>{"2", "68", "2.5"}));
}

TEST(schedule, launches_without_a_log_are_told_and_count_for_nothing) {
  auto records = slowing_run();
  records[1].log_share = 0;
  for (WorkerRecord& w : records[1].workers) w.busy_seconds = w.idle_seconds = 0;
  auto rows = rows_of(records);
  EXPECT_EQ(rows[1].schedule.imbalance->count, 6);
  EXPECT_EQ(cell(rows, 1, "notes"), "log off in 1 of 7 launches");
  for (Record& r : records) {
    if (r.scheduler == "omp_dynamic") r.log_share = 0;
  }
  rows = rows_of(records);
  EXPECT_EQ(cell(rows, 1, "busy"), "–");
  EXPECT_EQ(cell(rows, 1, "notes"), "log off");
  EXPECT_EQ(cell(rows, 0, "notes"), "");
}

TEST(schedule, a_cell_that_was_not_launched_stays_as_a_row_of_dashes) {
  auto records = slowing_run();
  auto planned = std::vector<Record>(records.begin(), records.begin() + 3);
  std::erase_if(records, [](const Record& r) { return r.scheduler == "thread_dynamic"; });
  const auto rows = summarise(records, planned, 0.5);
  for (const char* column : {"quality", "imbalance", "busy", "chunks", "migrations"})
    EXPECT_EQ(cell(rows, 2, column), "–") << column;
  EXPECT_EQ(schedule_data(rows).rows.size(), 3u);
}

TEST(schedule, records_of_older_schemas_have_no_such_table) {
  std::vector<Record> records;
  for (const Record& logged : slowing_run()) {
    auto json = to_json(make_record(logged.scheduler, logged.threads, logged.round, 0.5));
    json["schema"] = 1 + logged.round % 2;
    json["runtime"] = "";
    json["chunks_made"] = {8};
    json["workers"] = nlohmann::json::parse(R"([{"items": 8, "chunks": 8, "cpu": 0}])");
    records.push_back(record_from_json(json));
  }
  const auto rows = rows_of(records);
  EXPECT_TRUE(rows[1].fps);
  EXPECT_FALSE(schedule_table(rows));
  EXPECT_EQ(schedule_data(rows).rows.size(), rows.size());
  EXPECT_TRUE(chunk_data(rows).rows.empty());
  EXPECT_EQ(tables_as_text(rows, {"test", "title"}).find("Where the time went"), std::string::npos);
}

TEST(schedule, is_written_beside_the_scaling_table) {
  const auto folder =
      std::filesystem::temp_directory_path() / ("raysweep_tables_" + std::to_string(getpid()));
  write_tables(rows_of(slowing_run()), {"test", "title"}, folder);
  for (const char* file : {"scaling.md", "schedule.md", "schedule.csv", "chunks.csv"})
    EXPECT_TRUE(std::filesystem::exists(folder / file)) << file;
  EXPECT_FALSE(std::filesystem::exists(folder / "hyper-threading.md"));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace raysweep
