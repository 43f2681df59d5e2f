// Several experiments at once launch only once what they have in common.
#include <set>

#include "tests/experiments/fake_runner.h"

namespace raysweep {
namespace {

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

}  // namespace
}  // namespace raysweep
