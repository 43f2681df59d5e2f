// The runner with a launcher and a clock of the test's own: no process, no sleeping, no wall time.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "experiments/errors.h"
#include "experiments/runner.h"
#include "tests/results/make_record.h"

namespace raysweep {

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

}  // namespace raysweep
