// Which cells the runner launches, how often, and what it keeps of them.
#include "experiments/runner.h"

#include <map>
#include <set>

#include "experiments/estimate.h"
#include "experiments/launch.h"
#include "experiments/progress.h"
#include "results/run_data.h"
#include "tests/experiments/fake_runner.h"

namespace raysweep {
namespace {

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

TEST_F(RunnerTest, rays_that_differ_from_the_serial_ones_void_a_launch) {
  launcher.idle_scheduler = "thread_static";
  EXPECT_EQ(run().void_launches, 35);
  EXPECT_EQ(read_run(path).rows[2].notes.front(),
            "7 of 7 launches void: its rays are not those of the serial picture");
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
