// From `placement = "hyper-threading"` to its table, on machines that are not here: six cores with two
// hardware threads each, as in the published study, and others.
#include "results/hyper_threading.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <set>

#include "experiments/cell_record.h"
#include "experiments/run_folder.h"
#include "experiments/runner.h"
#include "results/run_data.h"

namespace raysweep {
namespace {

const std::string text =
    "experiment = \"ht\"\n[sweep]\nscheduler = \"thread_dynamic\"\nplacement = \"hyper-threading\"\n";

Machine machine_of(const Topology& topology) {
  Machine machine;
  machine.topology = topology;
  return machine;
}

Config config_for(const Machine& machine) { return parse_config(text, "ht.toml", {}, machine.size()); }

/// A core gives one frame a second to one thread, and a quarter more to two; rounds vary by some percent.
class FakeMachine final : public Launcher {
 public:
  explicit FakeMachine(Topology topology) : topology_(std::move(topology)) {}

  LaunchOutcome launch(const Cell& cell, double, double) override {
    Record r = picture(cell, 0).record.value();
    r.threads_seen = cell.threads;
    std::set<int> cores, processors;
    for (const int processor : place(cell.pin, cell.threads, topology_)) {
      processors.insert(processor);
      cores.insert(topology_.find(processor)->core);
      r.workers.push_back({.cpu = processor});
    }
    r.processors_seen = static_cast<int>(processors.size());
    r.cores_seen = static_cast<int>(cores.size());
    const bool bound = !processors.empty();
    const double fps =
        bound ? r.cores_seen * (r.processors_seen > r.cores_seen ? 1.25 : 1) : double(cell.processes);
    r.frame_seconds = {{(1 + 0.01 * (launched_++ % 5)) / fps}};
    return {r, {}, false};
  }

  LaunchOutcome picture(const Cell& cell, double) override {
    Record r = record_of(cell);
    r.image_hash = "right";
    r.rays.primary = 100;
    return {r, {}, false};
  }

 private:
  const Topology topology_;
  int launched_ = 0;
};

class HyperThreadingRun : public testing::Test {
 public:
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("raysweep_ht_" + std::to_string(getpid()));
  ~HyperThreadingRun() override { std::filesystem::remove_all(path); }

  RunData run(const Machine& machine) {
    FakeMachine launcher(machine.topology);
    std::vector<Experiment> experiments(1);
    experiments[0].config = config_for(machine);
    experiments[0].plan = make_plan(experiments[0].config, machine.size());
    experiments[0].folder =
        std::make_unique<RunFolder>(path, experiments[0].config, experiments[0].plan, machine, false);
    double clock = 0;
    (void)run_experiments(experiments, machine, {launcher, [&] { return clock += 0.01; }, true});
    return read_run(path);
  }
};

TEST_F(HyperThreadingRun, on_six_cores_tells_yield_packing_penalty_and_efficiencies) {
  const RunData data = run(machine_of(synthetic_topology("pack:1 core:6 pu:2")));
  const auto groups = hyper_threading_groups(data.rows);
  ASSERT_EQ(groups.size(), 1u);
  const HyperThreadingGroup& group = groups[0];
  EXPECT_EQ(group.cores(), 6);
  for (const auto& [ratio, expected] : {std::pair(group.yield, 1.25), {group.packing_penalty, 0.625}}) {
    EXPECT_NEAR(ratio->value, expected, 0.03 * expected);
    ASSERT_TRUE(ratio->interval);
    EXPECT_LE(ratio->interval->low, ratio->value);
    EXPECT_NEAR(ratio->interval->low, expected, 0.05 * expected);
    EXPECT_NEAR(ratio->interval->high, expected, 0.05 * expected);
  }
  EXPECT_NEAR(*group.one_each->core_efficiency, 1, 0.05);
  EXPECT_NEAR(*group.two_each->core_efficiency, 1.25, 0.05);
  EXPECT_NEAR(*group.packed->core_efficiency, 1.25, 0.05) << "three cores, with two threads each";
  EXPECT_NEAR(*hardware_thread_efficiency(*group.two_each), 0.625, 0.03);
  EXPECT_NEAR(*hardware_thread_efficiency(*group.packed), 0.625, 0.03);
}

TEST_F(HyperThreadingRun, shows_and_writes_its_table) {
  const RunData data = run(machine_of(synthetic_topology("pack:1 core:6 pu:2")));
  const std::string shown = tables_as_text(data.rows, data.context);
  EXPECT_NE(shown.find("yield: a second hardware thread adds 2"), std::string::npos) << shown;
  EXPECT_NE(shown.find("packing penalty: filling half the cores takes 3"), std::string::npos) << shown;
  write_tables(data.rows, data.context, path / "tables");
  for (const char* file : {"hyper-threading.md", "hyper-threading.csv"})
    EXPECT_TRUE(std::filesystem::exists(path / "tables" / file)) << file;
}

TEST(hyper_threading_config, is_answered_by_a_sentence_where_every_hardware_thread_is_a_core) {
  const Config config = config_for(machine_of(synthetic_topology("core:2 pu:1")));
  EXPECT_TRUE(config.not_here.starts_with("this machine shows no hyper-threading (2 cores, 2 processors)"))
      << config.not_here;
}

/// Thread count and pin of the cells that were asked for.
std::vector<std::pair<int, std::string>> asked(const Topology& topology) {
  const Machine machine = machine_of(topology);
  const Config config = config_for(machine);
  EXPECT_EQ(config.not_here, "");
  std::vector<std::pair<int, std::string>> cells;
  for (const PlannedCell& planned : make_plan(config, machine.size()).cells) {
    if (planned.asked) cells.emplace_back(planned.cell.threads, planned.cell.pin);
  }
  return cells;
}
using Asked = std::vector<std::pair<int, std::string>>;

/// Six fast cores with two hardware threads, then eight slow ones with one.
Topology hybrid() {
  Topology topology;
  for (int p = 0; p < 12; ++p) topology.hardware_threads.push_back({p, p / 2, p % 2, 0, 0, 1});
  for (int p = 12; p < 20; ++p) topology.hardware_threads.push_back({p, p - 6, 0, 0, 0, 0});
  return topology;
}

TEST(hyper_threading_config, plans_the_fast_cores_of_a_hybrid_machine) {
  EXPECT_EQ(asked(hybrid()), (Asked{{6, "0,2,4,6,8,10"}, {12, "0-11"}, {6, "0-5"}}));
}

TEST(hyper_threading_config, plans_every_core_of_a_large_machine) {
  const auto cells = asked(synthetic_topology("pack:2 numa:4 l3:4 core:4 pu:2"));
  ASSERT_EQ(cells.size(), 3u);
  EXPECT_EQ(cells[0].first, 128);
  EXPECT_EQ(cells[1], std::pair(256, std::string("0-255")));
  EXPECT_EQ(cells[2], std::pair(128, std::string("0-127")));
}

}  // namespace
}  // namespace raysweep
