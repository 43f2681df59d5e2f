// Runs that end early, and who may take them up.
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "results/run_data.h"
#include "tests/experiments/fake_runner.h"

namespace raysweep {
namespace {

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

TEST_F(RunnerTest, another_machine_does_not_take_up_a_run) {
  (void)run();
  machine.host = "elsewhere";
  EXPECT_NE(refusal(true).find("on another machine"), std::string::npos) << refusal(true);
}

TEST_F(RunnerTest, another_build_does_not_take_up_a_run) {
  (void)run();
  auto old = nlohmann::json::parse(std::ifstream(path / "machine.json"));
  old["build"]["commit"] = "another";
  std::ofstream(path / "machine.json") << old;
  EXPECT_NE(refusal(true).find("by another build of raysweep"), std::string::npos) << refusal(true);
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

}  // namespace
}  // namespace raysweep
