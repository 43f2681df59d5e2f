// The runner with a launcher and a clock of the test's own: no process, no sleeping, no wall time.
#include "experiments/runner.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "experiments/errors.h"
#include "experiments/estimate.h"
#include "experiments/launch.h"
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
  int pictures_that_work = -1;
  std::string wrong_scheduler, failing_scheduler, idle_scheduler;
  std::string noisy_scheduler;  // its frames take from 0.3 to 0.7 s, others 0.5 s
  std::vector<double> timeouts;

  LaunchOutcome launch(const Cell& cell, double, double timeout) override {
    if (launched == interrupt_after) return {std::nullopt, {}, true};
    launched++;
    clock += 10;
    timeouts.push_back(timeout);
    if (cell.scheduler == failing_scheduler) return {std::nullopt, "killed by signal 9", false};
    const double seconds = cell.scheduler == noisy_scheduler ? 0.3 + 0.1 * (launched % 5) : 0.5;
    Record r = make_record(cell.scheduler, cell.threads, 0, seconds, cell.processes);
    r.cell = cell.key();
    r.mode = cell.mode;
    r.chunk = cell.chunk_text();
    r.twin = cell.twin;
    r.rays.primary = cell.scheduler == idle_scheduler ? 50 : 100;
    r.image_hash = cell.scheduler == wrong_scheduler ? "other" : "right";
    return {r, {}, false};
  }
  LaunchOutcome picture(const Cell& cell, double) override {
    EXPECT_EQ(cell.scheduler, "serial");
    if (pictures == pictures_that_work) return {std::nullopt, "killed by signal 9", false};
    pictures++;
    clock += 3;
    Record r;
    r.image_hash = "right";
    r.rays.primary = 100;
    r.frame_seconds = {{2}};
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
      "\"thread_static\"\nthreads = 2\n[measure]\nbudget = \"2 h\"\n",
      "x.toml", {}, {2, 2});
  // For each mode serial, one thread, co-run and two threads; and one twin.
  static constexpr size_t cells = 9;

  RunnerTest() {
    std::filesystem::remove_all(path);
    machine.topology = synthetic_topology("core:2 pu:1");
  }
  ~RunnerTest() override { std::filesystem::remove_all(path); }

  [[nodiscard]] Experiment experiment(const Config& of, const std::filesystem::path& folder,
                                      bool resume) const {
    Experiment e{of, make_plan(of, machine.size()), nullptr};
    e.folder = std::make_unique<RunFolder>(folder, e.config, e.plan, machine, resume);
    return e;
  }
  [[nodiscard]] RunnerTools tools() {
    return {launcher, [this] { return launcher.clock; }, true};
  }
  RunReport run(bool resume = false) {
    std::vector<Experiment> one;
    one.push_back(experiment(config, path, resume));
    return run_experiments(one, machine, tools()).reports.front();
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
  EXPECT_EQ(records().size(), cells * 7);
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
  for (size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i].round, static_cast<int>(i / cells));
}

TEST_F(RunnerTest, a_wrong_picture_voids_its_launch_and_says_why) {
  launcher.wrong_scheduler = "thread_static";
  const RunReport report = run();
  EXPECT_EQ(report.void_launches, 5 * 7);
  for (const Record& r : records()) {
    EXPECT_EQ(r.valid, r.scheduler == "serial");
    if (!r.valid) {
      EXPECT_EQ(r.reason, "picture other differs from the serial one, right");
    }
  }
}

TEST_F(RunnerTest, a_launch_that_dies_is_a_void_record_and_the_run_goes_on) {
  launcher.failing_scheduler = "thread_static";
  EXPECT_EQ(run().void_launches, 35);
  EXPECT_EQ(records().size(), cells * 7);
  const RunData data = read_run(path);
  EXPECT_FALSE(data.rows[2].fps);
  EXPECT_NE(data.rows[2].notes.front().find("killed by signal 9"), std::string::npos);
}

TEST_F(RunnerTest, the_cells_share_the_budget) {
  config.measure.budget_seconds = 185;
  const RunReport report = run();
  EXPECT_EQ(report.end, RunEnd::out_of_budget);
  EXPECT_EQ(report.whole_rounds, 2);
  EXPECT_EQ(records().size(), 18u) << "18 launches of ten seconds begin within 185, after two pictures of 3";
}

TEST_F(RunnerTest, an_interrupted_run_keeps_its_launches_and_resumes_where_it_stopped) {
  launcher.interrupt_after = 11;
  EXPECT_EQ(run().end, RunEnd::interrupted);
  EXPECT_EQ(records().size(), 11u);
  launcher.interrupt_after = -1;
  EXPECT_EQ(run(true).end, RunEnd::complete);
  EXPECT_EQ(launcher.launched, 63) << "no launch twice";
  std::set<std::pair<std::string, int>> seen;
  std::set<int> numbers;
  for (const Record& r : records()) {
    seen.insert({r.cell, r.round});
    numbers.insert(r.launch);
  }
  EXPECT_EQ(seen.size(), 63u);
  EXPECT_EQ(numbers.size(), 63u);
}

TEST_F(RunnerTest, void_launches_are_tried_again_on_resume_and_the_later_record_counts) {
  launcher.failing_scheduler = "thread_static";
  EXPECT_EQ(run().void_launches, 35);
  launcher.failing_scheduler.clear();
  EXPECT_EQ(run(true).void_launches, 0);
  EXPECT_EQ(records().size(), cells * 7 + 35);
  for (const CellRow& row : read_run(path).rows) EXPECT_EQ(row.void_launches, 0) << row.cell.cell;
}

TEST_F(RunnerTest, rays_that_differ_from_the_serial_ones_void_a_launch) {
  launcher.idle_scheduler = "thread_static";
  EXPECT_EQ(run().void_launches, 35);
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
  EXPECT_EQ(records().size(), cells * 7);
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

TEST_F(RunnerTest, what_has_not_converged_is_launched_again_with_what_it_is_compared_with) {
  launcher.noisy_scheduler = "thread_static";
  EXPECT_EQ(run().end, RunEnd::complete);
  std::map<std::string, int> launches;
  for (const Record& r : records()) launches[r.cell]++;
  ASSERT_EQ(launches.size(), cells);
  for (const auto& [cell, count] : launches)
    EXPECT_EQ(count, 28) << cell << ": noisy, or a base of such a one";
}

TEST_F(RunnerTest, what_has_converged_is_left_alone) {
  config = parse_config(
      "experiment = \"x\"\n[scene]\nmodes = [\"low\"]\n[sweep]\nscheduler = "
      "[\"thread_static\", \"thread_cyclic\"]\nthreads = [1, 2]\n[measure]\nmax_launches = 20\nbudget = \"2 "
      "h\"\n",
      "x.toml", {}, {2, 2});
  launcher.noisy_scheduler = "thread_cyclic";
  (void)run();
  std::map<std::string, int> launches;
  for (const Record& r : records()) {
    if (r.twin == 0 && r.processes == 1) launches[r.scheduler + std::to_string(r.threads)]++;
  }
  const std::map<std::string, int> expected{{"serial1", 20},
                                            {"thread_static1", 7},
                                            {"thread_static2", 7},
                                            {"thread_cyclic1", 20},
                                            {"thread_cyclic2", 20}};
  EXPECT_EQ(launches, expected);
}

TEST_F(RunnerTest, a_resumed_run_ends_with_the_launches_of_an_undisturbed_one) {
  launcher.noisy_scheduler = "thread_static";
  (void)run();
  std::map<std::string, int> undisturbed, resumed;
  for (const Record& r : records()) undisturbed[r.cell]++;
  std::filesystem::remove_all(path);
  for (launcher.launched = 0; launcher.launched < 28 * int(cells);) {
    launcher.interrupt_after = launcher.launched + 17;
    if (run(launcher.launched > 0).end == RunEnd::complete) break;
  }
  for (const Record& r : records()) resumed[r.cell]++;
  EXPECT_EQ(resumed, undisturbed);
}

TEST_F(RunnerTest, a_cell_that_never_works_is_given_up_after_the_first_rounds) {
  launcher.failing_scheduler = "thread_static";
  launcher.noisy_scheduler = "serial";
  (void)run();
  std::map<std::string, int> launches;
  for (const Record& r : records()) launches[r.scheduler + (r.processes > 1 ? " together" : "")]++;
  EXPECT_EQ(launches["thread_static"], 5 * 7);
  EXPECT_EQ(launches["serial"], 2 * 28);
}

TEST_F(RunnerTest, a_launch_may_take_many_times_as_long_as_the_serial_picture) {
  (void)run();
  EXPECT_EQ(*std::ranges::min_element(launcher.timeouts), default_timeout(Cell(), 0.3, 3));
  Cell together;
  together.processes = 4;
  EXPECT_GT(default_timeout(together, 0.3, 3), default_timeout(Cell(), 0.3, 3));
  std::filesystem::remove_all(path);
  launcher.timeouts.clear();
  config.measure.timeout_seconds = 2;
  (void)run();
  for (const double timeout : launcher.timeouts) EXPECT_EQ(timeout, 2);
}

/// Serial, one and two threads of thread_static, co-run and twin are in both.
TEST_F(RunnerTest, experiments_share_the_cells_that_both_have) {
  const auto other = parse_config(
      "experiment = \"y\"\n[scene]\nmodes = [\"low\"]\n[sweep]\nscheduler = [\"thread_static\", "
      "\"thread_cyclic\"]\nthreads = 2\n[measure]\nlaunches = 8\nbudget = \"2 h\"\n",
      "y.toml", {}, {2, 2});
  std::vector<Experiment> both;
  both.push_back(experiment(config, path / "x", false));
  both.push_back(experiment(other, path / "y", false));
  const auto reports = run_experiments(both, machine, tools()).reports;
  const auto of_x = read_records(path / "x" / "records.jsonl"),
             of_y = read_records(path / "y" / "records.jsonl");
  EXPECT_EQ(of_x.size(), cells * 7);
  EXPECT_EQ(of_y.size(), 7u * 8) << "two more cells, an eighth round";
  EXPECT_EQ(reports[1].launches, 56);
  EXPECT_EQ(launcher.launched, 7 * 9 + 7 * 2 + 7) << "the five of both once a round";
  EXPECT_EQ(launcher.pictures, 2);
  for (const Record& r : of_x) EXPECT_EQ(r.experiment, "x");
  for (const Record& r : of_y) EXPECT_EQ(r.experiment, "y");
  std::set<int> numbers;
  for (const Record& r : of_y) numbers.insert(r.launch);
  EXPECT_EQ(numbers.size(), 56u);
  EXPECT_EQ(*numbers.rbegin(), 55);
}

TEST_F(RunnerTest, the_longest_timeout_of_those_that_share_a_launch_counts) {
  Config patient = config;
  config.measure.timeout_seconds = 2;
  patient.experiment = "y";
  patient.measure.timeout_seconds = 90;
  std::vector<Experiment> both;
  both.push_back(experiment(config, path / "x", false));
  both.push_back(experiment(patient, path / "y", false));
  (void)run_experiments(both, machine, tools());
  for (const double timeout : launcher.timeouts) EXPECT_EQ(timeout, 90);
}

TEST_F(RunnerTest, a_picture_that_cannot_be_had_ends_the_run_and_keeps_its_report) {
  launcher.pictures_that_work = 1;
  std::vector<Experiment> one;
  one.push_back(experiment(config, path, false));
  const RunOutcome outcome = run_experiments(one, machine, tools());
  EXPECT_NE(outcome.failure.find("the serial picture cannot be rendered"), std::string::npos)
      << outcome.failure;
  EXPECT_EQ(outcome.reports.front().end, RunEnd::failed);
  EXPECT_EQ(outcome.reports.front().launches, static_cast<int>(records().size()));
}

TEST_F(RunnerTest, a_resumed_run_that_ends_early_again_is_not_complete_for_any_experiment) {
  Config other = config;
  other.experiment = "y";
  const auto both = [&](bool resume) {
    std::vector<Experiment> list;
    list.push_back(experiment(config, path / "x", resume));
    list.push_back(experiment(other, path / "y", resume));
    return run_experiments(list, machine, tools()).reports;
  };
  launcher.interrupt_after = 20;
  (void)both(false);
  launcher.interrupt_after = launcher.launched + 1;
  for (const RunReport& report : both(true)) EXPECT_EQ(report.end, RunEnd::interrupted);
}

TEST_F(RunnerTest, another_build_does_not_take_up_a_run) {
  (void)run();
  auto old = nlohmann::json::parse(std::ifstream(path / "machine.json"));
  old["build"]["commit"] = "another";
  std::ofstream(path / "machine.json") << old;
  EXPECT_NE(refusal(true).find("by another build of raysweep"), std::string::npos) << refusal(true);
}

TEST_F(RunnerTest, experiments_whose_launches_are_of_other_lengths_share_pictures_only) {
  Config longer = config;
  longer.experiment = "y";
  longer.measure.seconds = 1;
  std::vector<Experiment> both;
  both.push_back(experiment(config, path / "x", false));
  both.push_back(experiment(longer, path / "y", false));
  (void)run_experiments(both, machine, tools());
  EXPECT_EQ(launcher.launched, 2 * 7 * int(cells));
  EXPECT_EQ(launcher.pictures, 2);
}

/// A picture of 2 s at an eighth of the width and height; launches time 0.3 s at least.
TEST_F(RunnerTest, the_time_that_a_run_would_take_is_told_before) {
  const Plan plan = make_plan(config, machine.size());
  const TimeEstimate estimate = estimate_time({config}, {plan}, machine.size(), tools());
  EXPECT_EQ(launcher.launched, 0);
  const double frame = 2 * 64, start = 1;
  const double serial = start + 3 * frame, one = start + 2 * frame, together = one, two = start + frame;
  const double pictures = 2 * (start + frame);
  EXPECT_NEAR(estimate.first_rounds, pictures + 7 * (2 * (serial + one + together + two) + two), 1e-6);
  EXPECT_NEAR(estimate.all_rounds, pictures + 28 * (2 * (serial + one + together + two) + two), 1e-6);
}

TEST(launch, is_warm_when_frames_have_stopped_getting_faster) {
  EXPECT_FALSE(has_settled({1}));
  EXPECT_FALSE(has_settled({1, 0.9}));
  EXPECT_TRUE(has_settled({1, 0.9, 0.89}));
  EXPECT_TRUE(has_settled({1, 0.9, 1.5})) << "slower is noise";
  EXPECT_FALSE(has_settled({1, 0.9, 1.5, 0.8}));
}

TEST(progress, the_time_left_follows_the_pace_and_never_exceeds_the_budget) {
  EXPECT_LT(seconds_left(0, 10, 0, 100), 0) << "not known yet";
  EXPECT_EQ(seconds_left(5, 10, 20, 100), 20);
  EXPECT_EQ(seconds_left(1, 100, 20, 100), 80);
  EXPECT_EQ(seconds_left(10, 10, 20, 100), 0);
}

}  // namespace
}  // namespace raysweep
