// Kernel experiments, as a user runs them.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/program/processes.h"
#include "tests/program/program.h"

namespace raysweep {
namespace {

const std::string head = "# Is it fast?\nexperiment = \"tiny\"\nkind = \"kernel\"\n";
const std::string tiny = head +
                         "[sweep]\nmethod = \"wald\"\nprecision = \"float\"\nvariants = \"star\"\n"
                         "protocol = [\"random\", \"hit-rate\"]\nhit_rate = [0, 0.5, 1]\n"
                         "[measure]\nrounds = 2\nsamples = 2\nmin_time = 0.00001\n";

class KernelRun : public testing::Test {
 public:
  TemporaryFolder folder;

  void SetUp() override {
    if (!RAYSWEEP_HAS_BENCHMARK) GTEST_SKIP() << "built without Google Benchmark";
  }
  [[nodiscard]] ProgramResult run(const std::string& text, const std::string& out,
                                  std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"run", folder.write("tiny.toml", text), "--out", folder.file(out)});
    return run_program(more);
  }
  [[nodiscard]] std::string in(const std::string& out, const std::string& name) const {
    return read_file(folder.file(out + "/" + name));
  }
  [[nodiscard]] static size_t lines(const std::string& text) {
    return static_cast<size_t>(std::count(text.begin(), text.end(), '\n'));
  }
  /// Cell and round of each record, in order.
  [[nodiscard]] std::vector<std::pair<std::string, int>> order(const std::string& out) const {
    std::vector<std::pair<std::string, int>> list;
    std::istringstream text(in(out, "records.jsonl"));
    for (std::string line; std::getline(text, line);) {
      const auto record = nlohmann::json::parse(line);
      list.emplace_back(record["cell"], record["round"]);
    }
    return list;
  }
};

TEST_F(KernelRun, leaves_a_record_for_each_cell_and_round_and_tables) {
  const ProgramResult result = run(tiny, "a");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("nanoseconds a test of base kernels"), std::string::npos) << result.out;
  const auto plan = nlohmann::json::parse(in("a", "plan.json"));
  const size_t cells = plan["cells"].size();
  EXPECT_EQ(lines(in("a", "records.jsonl")), 2 * cells);
  const auto first =
      nlohmann::json::parse(in("a", "records.jsonl").substr(0, in("a", "records.jsonl").find('\n')));
  EXPECT_EQ(first["kind"], "kernel");
  EXPECT_EQ(first["valid"], true);
  EXPECT_EQ(first["seconds"].size(), 2u);
  for (const char* name : {"speed-float", "hit-rates-float", "factors-float", "left-out"}) {
    for (const char* suffix : {".md", ".csv"})
      EXPECT_NE(in("a", "tables/" + std::string(name) + suffix), "") << name << suffix;
  }
  EXPECT_EQ(lines(in("a", "tables/cells.csv")), cells + 1);
  EXPECT_EQ(in("a", "config.toml"), tiny);
  EXPECT_NE(in("a", "machine.json"), "");
}

TEST_F(KernelRun, shuffles_each_round_by_its_seed) {
  ASSERT_EQ(run(tiny, "a").exit_code, 0);
  ASSERT_EQ(run(tiny, "b").exit_code, 0);
  ASSERT_EQ(run(tiny, "c", {"--seed", "2"}).exit_code, 0);
  const auto a = order("a");
  EXPECT_EQ(a, order("b"));
  EXPECT_NE(a, order("c"));
  const size_t half = a.size() / 2;
  EXPECT_TRUE(std::all_of(a.begin(), a.end(), [&](const auto& one) {
    return (one.second == 1) == (&one >= &a[half]);
  })) << "one round after the other";
  bool differs = false;
  for (size_t i = 0; i < half; ++i) differs = differs || a[i].first != a[half + i].first;
  EXPECT_TRUE(differs) << "each round has an order of its own";
}

TEST_F(KernelRun, is_told_anew_from_its_records_alone) {
  ASSERT_EQ(run(tiny, "a").exit_code, 0);
  const std::string before = in("a", "tables/cells.csv");
  std::filesystem::remove_all(folder.file("a/tables"));
  const ProgramResult report = run_program({"report", folder.file("a")});
  EXPECT_EQ(report.exit_code, 0) << report.err;
  EXPECT_EQ(in("a", "tables/cells.csv"), before);
  const auto document = nlohmann::json::parse(run_program({"report", folder.file("a"), "--json"}).out);
  EXPECT_EQ(2 * document[0]["rows"].size(), lines(in("a", "records.jsonl")));
}

TEST_F(KernelRun, goes_on_where_it_was_stopped) {
  ASSERT_EQ(run(tiny, "whole").exit_code, 0);
  ASSERT_EQ(run(tiny, "cut").exit_code, 0);
  const std::string all = in("cut", "records.jsonl");
  size_t end = 0;
  for (int i = 0; i < 10; ++i) end = all.find('\n', end) + 1;
  std::ofstream(folder.file("cut/records.jsonl"), std::ios::binary) << all.substr(0, end + 100);
  EXPECT_EQ(run(tiny, "cut").exit_code, 2) << "without --resume a folder with a run is refused";
  const ProgramResult resumed = run(tiny, "cut", {"--resume"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_TRUE(in("cut", "records.jsonl").starts_with(all.substr(0, end))) << "what is finished is kept";
  EXPECT_EQ(order("cut"), order("whole"));
  const ProgramResult other = run(tiny, "cut", {"--resume", "--seed", "3"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_NE(other.err.find("was made from another config"), std::string::npos) << other.err;
}

TEST_F(KernelRun, ctrl_c_keeps_finished_records_and_says_how_to_go_on) {
  const std::string config = folder.write(
      "long.toml", head + "[sweep]\nmethod = \"wald\"\n[measure]\nrounds = 1000\nmin_time = 0.01\n");
  const std::string out = folder.file("long");
  Program program({"run", config, "--out", out});
  ASSERT_TRUE(becomes_true([&] { return !read_file(out + "/records.jsonl").empty(); }));
  program.send(SIGINT);
  const ProgramResult result = program.wait();
  EXPECT_EQ(result.exit_code, 130);
  EXPECT_NE(result.err.find("of 2000 records are finished and kept; go on with --resume --out " + out),
            std::string::npos)
      << result.err;
  EXPECT_TRUE(read_file(out + "/records.jsonl").ends_with('\n'));
}

TEST_F(KernelRun, ends_with_its_budget_and_says_so) {
  const ProgramResult result = run(head + "[sweep]\nmethod = \"wald\"\n[measure]\nrounds = 1000\n", "a",
                                   {"--budget", "0.003", "--json"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.err.find("the budget of 0 s was used up after "), std::string::npos) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json[0]["complete"], false);
  EXPECT_EQ(json[0]["records"], lines(in("a", "records.jsonl")));
}

TEST_F(KernelRun, a_dry_run_names_the_cells_and_writes_nothing) {
  const size_t before = folder.entries() + 1;  // the config
  const ProgramResult result = run(tiny, "dry", {"--dry-run"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("\nwald/division=late/float/hit-rate/0.5\n"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("left out: wald order=weights_first float: "), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("\nAbout "), std::string::npos) << result.out;
  EXPECT_EQ(folder.entries(), before);
}

TEST_F(KernelRun, bad_configs_are_refused_whole) {
  const ProgramResult result = run(head + "[sweep]\nmethod = \"wlad\"\nvariants = \"full\"\n", "bad");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find("tiny.toml:5: unknown method \"wlad\"; built here: "), std::string::npos)
      << result.err;
  EXPECT_NE(result.err.find("tiny.toml:6: unknown variants \"full\"; possible: base, star, product"),
            std::string::npos)
      << result.err;
  EXPECT_FALSE(std::filesystem::exists(folder.file("bad")));
}

/// The configs of M11 with little to do.
class SmallKernelRun : public KernelRun {
 public:
  [[nodiscard]] ProgramResult run_config(const std::string& name, const std::vector<std::string>& set) const {
    std::vector<std::string> arguments{
        "run",   std::string(RAYSWEEP_SOURCE_DIR) + "/experiments/configs/" + name,
        "--out", folder.file("a"),
        "--set", "measure.rounds=2",
        "--set", "measure.samples=1",
        "--set", "measure.min_time=0.00001"};
    for (const std::string& one : set) arguments.insert(arguments.end(), {"--set", one});
    return run_program(arguments);
  }
  void expect_a_run_of(size_t cells, const std::vector<std::string>& tables) const {
    EXPECT_EQ(nlohmann::json::parse(in("a", "plan.json"))["cells"].size(), cells);
    EXPECT_EQ(lines(in("a", "records.jsonl")), 2 * cells);
    EXPECT_EQ(in("a", "records.jsonl").find("\"valid\":false"), std::string::npos);
    EXPECT_EQ(lines(in("a", "tables/cells.csv")), cells + 1);
    for (const std::string& table : tables) {
      for (const char* suffix : {".md", ".csv", ".tex"})
        EXPECT_NE(in("a", "tables/" + table + suffix), "") << table << suffix;
    }
    const std::string before = in("a", "tables/cells.csv");
    EXPECT_EQ(run_program({"report", folder.file("a")}).exit_code, 0);
    EXPECT_EQ(in("a", "tables/cells.csv"), before);
  }
};

TEST_F(SmallKernelRun, times_expressions_of_four_floats) {
  const ProgramResult result = run_config("m11-t2.toml", {"sweep.iterations=[10, 1000]"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("expression_templates: ticks of operations timed one by one"), std::string::npos)
      << result.out;
  expect_a_run_of(12, {"expression_templates", "expression_templates-ticks"});
}

TEST_F(SmallKernelRun, times_virtual_calls) {
  const ProgramResult result = run_config("m11-virtual.toml", {"sweep.length=[1, 100, 10000]"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("virtual_calls: nanoseconds an operation"), std::string::npos) << result.out;
  expect_a_run_of(30, {"virtual_calls"});
}

TEST_F(SmallKernelRun, times_tests_without_branches_and_dot_products) {
  const ProgramResult result =
      run_config("m11-branch.toml", {"sweep.hit_rate=[0, 1]", "sweep.dot=[\"scalar\", \"highway\"]"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  expect_a_run_of(6, {"branches", "dot_products"});
}

TEST(KernelRunWithoutBenchmark, is_refused_with_what_to_do) {
  if (RAYSWEEP_HAS_BENCHMARK) GTEST_SKIP() << "built with Google Benchmark";
  const TemporaryFolder folder;
  const ProgramResult result =
      run_program({"run", folder.write("tiny.toml", tiny), "--out", folder.file("a")});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find("Google Benchmark, which was not found when this was built; install "),
            std::string::npos)
      << result.err;
  EXPECT_FALSE(std::filesystem::exists(folder.file("a")));
}

}  // namespace
}  // namespace raysweep
