// The runner with a launcher and a clock of the test's own: no process, no sleeping, no wall time.
#include "experiments/runner.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <set>

#include "experiments/errors.h"
#include "experiments/progress.h"
#include "results/run_data.h"
#include "tests/results/make_record.h"

namespace raysweep {
namespace {

/// Launches take ten seconds of the fake clock each.
class FakeLauncher final : public Launcher {
 public:
  double clock = 1000;
  int launched = 0, pictures = 0;
  int interrupt_after = -1;  // launches
  std::string wrong_scheduler, failing_scheduler, idle_scheduler;

  LaunchOutcome launch(const Cell& cell, double) override {
    if (launched == interrupt_after) return {std::nullopt, {}, true};
    launched++;
    clock += 10;
    if (cell.scheduler == failing_scheduler) return {std::nullopt, "killed by signal 9", false};
    Record r = make_record(cell.scheduler, cell.threads, 0, 0.5, cell.processes);
    r.cell = cell.key();
    r.mode = cell.mode;
    r.chunk = cell.chunk_text();
    r.rays.primary = cell.scheduler == idle_scheduler ? 50 : 100;
    r.image_hash = cell.scheduler == wrong_scheduler ? "other" : "right";
    return {r, {}, false};
  }
  LaunchOutcome picture(const Cell& cell) override {
    EXPECT_EQ(cell.scheduler, "serial");
    pictures++;
    Record r;
    r.image_hash = "right";
    r.rays.primary = 100;
    return {r, {}, false};
  }
};

class RunnerTest : public testing::Test {
 public:
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("raysweep_run_" + std::to_string(getpid()));
  Machine machine;
  FakeLauncher launcher;
  Config config = parse_config(
      "experiment = \"x\"\n[scene]\nmodes = [\"low\", \"hard\"]\n[sweep]\nscheduler = "
      "\"thread_static\"\nthreads = 2\n",
      "x.toml", {}, {2, 2});

  RunnerTest() {
    std::filesystem::remove_all(path);
    machine.topology = synthetic_topology("core:2 pu:1");
  }
  ~RunnerTest() override { std::filesystem::remove_all(path); }

  RunReport run(bool resume = false) {
    const Plan plan = make_plan(config, machine.size());
    RunFolder folder(path, config, plan, machine, resume);
    return run_plan(config, plan, machine, folder, {launcher, [this] { return launcher.clock; }, true});
  }
  /// The sentence by which a run is refused.
  std::string refusal(bool resume) {
    try {
      (void)run(resume);
      return "";
    } catch (const RequestError& error) {
      return error.what();
    }
  }
  [[nodiscard]] std::vector<Record> records() const { return read_records(path / "records.jsonl"); }
};

TEST_F(RunnerTest, every_cell_is_launched_in_every_round_and_each_picture_rendered_once) {
  const RunReport report = run();
  EXPECT_EQ(report.end, RunEnd::complete);
  EXPECT_EQ(launcher.pictures, 2) << "one a mode";
  EXPECT_EQ(records().size(), 2u * 4 * 7) << "serial, one thread, co-run, two threads";
  std::set<std::pair<std::string, int>> seen;
  for (const Record& r : records()) {
    EXPECT_TRUE(r.valid);
    EXPECT_TRUE(seen.insert({r.cell, r.round}).second);
    EXPECT_EQ(r.seed, 1u);
    EXPECT_EQ(r.machine.pus, 2);
  }
  for (const char* file : {"config.toml", "plan.json", "machine.json"})
    EXPECT_TRUE(std::filesystem::exists(path / file));
}

TEST_F(RunnerTest, launches_of_different_cells_are_interleaved) {
  (void)run();
  const auto all = records();
  for (size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i].round, static_cast<int>(i / 8));
}

TEST_F(RunnerTest, a_wrong_picture_voids_its_launch_and_says_why) {
  launcher.wrong_scheduler = "thread_static";
  const RunReport report = run();
  EXPECT_EQ(report.void_launches, 2 * 2 * 7);
  for (const Record& r : records()) {
    EXPECT_EQ(r.valid, r.scheduler == "serial");
    if (!r.valid) {
      EXPECT_EQ(r.reason, "picture other differs from the serial one, right");
    }
  }
}

TEST_F(RunnerTest, a_launch_that_dies_is_a_void_record_and_the_run_goes_on) {
  launcher.failing_scheduler = "thread_static";
  EXPECT_EQ(run().void_launches, 28);
  EXPECT_EQ(records().size(), 56u);
  const RunData data = read_run(path);
  EXPECT_FALSE(data.rows[2].fps);
  EXPECT_NE(data.rows[2].notes.front().find("killed by signal 9"), std::string::npos);
}

TEST_F(RunnerTest, the_cells_share_the_budget) {
  config.measure.budget_seconds = 165;
  const RunReport report = run();
  EXPECT_EQ(report.end, RunEnd::out_of_budget);
  EXPECT_EQ(report.whole_rounds, 2);
  EXPECT_EQ(records().size(), 17u) << "17 launches of ten seconds begin within 165";
}

TEST_F(RunnerTest, an_interrupted_run_keeps_its_launches_and_resumes_where_it_stopped) {
  launcher.interrupt_after = 11;
  EXPECT_EQ(run().end, RunEnd::interrupted);
  EXPECT_EQ(records().size(), 11u);
  launcher.interrupt_after = -1;
  EXPECT_EQ(run(true).end, RunEnd::complete);
  EXPECT_EQ(launcher.launched, 56) << "no launch twice";
  std::set<std::pair<std::string, int>> seen;
  std::set<int> numbers;
  for (const Record& r : records()) {
    seen.insert({r.cell, r.round});
    numbers.insert(r.launch);
  }
  EXPECT_EQ(seen.size(), 56u);
  EXPECT_EQ(numbers.size(), 56u);
}

TEST_F(RunnerTest, void_launches_are_tried_again_on_resume_and_the_later_record_counts) {
  launcher.failing_scheduler = "thread_static";
  EXPECT_EQ(run().void_launches, 28);
  launcher.failing_scheduler.clear();
  EXPECT_EQ(run(true).void_launches, 0);
  EXPECT_EQ(records().size(), 56u + 28);
  for (const CellRow& row : read_run(path).rows) EXPECT_EQ(row.void_launches, 0) << row.cell.cell;
}

TEST_F(RunnerTest, rays_that_differ_from_the_serial_ones_void_a_launch) {
  launcher.idle_scheduler = "thread_static";
  EXPECT_EQ(run().void_launches, 28);
  EXPECT_EQ(read_run(path).rows[2].notes.front(),
            "7 of 7 launches void: its rays are not those of the serial picture");
}

TEST_F(RunnerTest, another_machine_does_not_take_up_a_run) {
  (void)run();
  machine.host = "elsewhere";
  EXPECT_NE(refusal(true).find("on another machine"), std::string::npos) << refusal(true);
}

TEST_F(RunnerTest, a_line_cut_by_a_kill_is_dropped_on_resume) {
  launcher.interrupt_after = 3;
  (void)run();
  std::ofstream(path / "records.jsonl", std::ios::app) << "{\"schema\": 1, \"kin";
  launcher.interrupt_after = -1;
  EXPECT_EQ(run(true).end, RunEnd::complete);
  EXPECT_EQ(records().size(), 56u);
}

TEST_F(RunnerTest, a_folder_with_a_run_is_taken_up_only_on_request_and_only_by_the_same_config) {
  (void)run();
  EXPECT_NE(refusal(false).find("holds a run already"), std::string::npos) << refusal(false);
  config.text += "# changed\n";
  EXPECT_NE(refusal(true).find("was made from another config"), std::string::npos) << refusal(true);
}

TEST_F(RunnerTest, a_folder_in_use_is_refused) {
  const Plan plan = make_plan(config, machine.size());
  const RunFolder first(path, config, plan, machine, false);
  try {
    const RunFolder second(path, config, plan, machine, true);
    FAIL();
  } catch (const RequestError& error) {
    EXPECT_NE(std::string(error.what())
                  .find("another run is writing here (process " + std::to_string(getpid()) + ")"),
              std::string::npos);
  }
}

TEST_F(RunnerTest, tables_come_byte_for_byte_from_the_records) {
  (void)run();
  const auto text = [&] {
    const RunData data = read_run(path);
    return tables_as_text(data.rows, data.context);
  };
  EXPECT_EQ(text(), text());
  EXPECT_NE(text().find("fps of thread_static"), std::string::npos) << text();
}

TEST(progress, the_time_left_follows_the_pace_and_never_exceeds_the_budget) {
  EXPECT_LT(seconds_left(0, 10, 0, 100), 0) << "not known yet";
  EXPECT_EQ(seconds_left(5, 10, 20, 100), 20);
  EXPECT_EQ(seconds_left(1, 100, 20, 100), 80);
  EXPECT_EQ(seconds_left(10, 10, 20, 100), 0);
}

}  // namespace
}  // namespace raysweep
