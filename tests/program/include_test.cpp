// Lists of experiments, and their quick forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/program/program.h"

namespace raysweep {
namespace {

/// An experiment of two small cells, of which the quick form has one.
std::string tiny(const std::string& name, const std::string& budget) {
  return "# Which?\nexperiment = \"" + name +
         "\"\n[sweep]\nwidth = [8, 16]\nheight = 8\nscheduler = \"serial\"\n[measure]\nlaunches = 2\n"
         "max_launches = 2\ntwins = 0\nseconds = 0\nbudget = \"" +
         budget + "\"\n[quick]\nset = [\"width=8\", \"measure.launches=1\", \"measure.max_launches=1\"]\n";
}

class Include : public testing::Test {
 public:
  TemporaryFolder folder;
  std::string list;

  Include() {
    (void)folder.write("a.toml", tiny("a", "1 min"));
    (void)folder.write("b.toml", tiny("b", "3 min"));
    list = folder.write("all.toml", "# Both?\nexperiment = \"all\"\ninclude = [\"a.toml\", \"b.toml\"]\n");
  }

  [[nodiscard]] static nlohmann::json plans(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "run");
    arguments.insert(arguments.end(), {"--dry-run", "--json"});
    const ProgramResult result = run_program(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return nlohmann::json::parse(result.out);
  }

  [[nodiscard]] size_t records(const std::string& experiment) const {
    const std::string text = read_file(folder.file("out/" + experiment + "/records.jsonl"));
    return static_cast<size_t>(std::count(text.begin(), text.end(), '\n'));
  }
};

TEST_F(Include, each_experiment_goes_to_a_folder_of_its_name) {
  const ProgramResult result = run_program({"run", list, "--out", folder.file("out")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(records("a"), 4u);
  EXPECT_EQ(records("b"), 4u);
}

TEST_F(Include, a_list_of_one_has_its_folder_too) {
  const std::string one = folder.write("one.toml", "experiment = \"one\"\ninclude = [\"a.toml\"]\n");
  const ProgramResult result = run_program({"run", one, "--quick", "--out", folder.file("out")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(records("a"), 1u);
}

TEST_F(Include, quick_runs_what_the_files_say_is_quick_and_set_wins_over_it) {
  const ProgramResult result =
      run_program({"run", list, "--quick", "--set", "width=32", "--out", folder.file("out")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(records("a"), 1u) << "one cell, once";
  const std::string record = read_file(folder.file("out/a/records.jsonl"));
  EXPECT_NE(record.find("\"width\":32"), std::string::npos) << record;
}

TEST_F(Include, an_interrupted_list_goes_on_where_it_was) {
  ASSERT_EQ(run_program({"run", list, "--out", folder.file("out")}).exit_code, 0);
  ASSERT_EQ(run_program({"run", list, "--resume", "--out", folder.file("out")}).exit_code, 0);
  EXPECT_EQ(records("a"), 4u) << "nothing was left to do";
}

TEST_F(Include, the_budget_of_a_list_is_shared_as_its_files_share_theirs) {
  const auto of_list = plans({list, "--budget", "2"});
  ASSERT_EQ(of_list.size(), 2u);
  EXPECT_EQ(of_list[0]["budget_seconds"], 30);
  EXPECT_EQ(of_list[1]["budget_seconds"], 90);
}

TEST_F(Include, the_budget_of_files_is_that_of_each) {
  const auto of_files = plans({folder.file("a.toml"), folder.file("b.toml"), "--budget", "2"});
  ASSERT_EQ(of_files.size(), 2u);
  EXPECT_EQ(of_files[0]["budget_seconds"], 120);
  EXPECT_EQ(of_files[1]["budget_seconds"], 120);
}

TEST_F(Include, the_errors_of_all_files_are_told_and_nothing_is_written) {
  (void)folder.write("a.toml", "experiment = \"a\"\n[sweep]\nthreads = 0\n");
  (void)folder.write("b.toml", "experiment = \"b\"\nspeed = 3\n");
  const ProgramResult result = run_program({"run", list, "--out", folder.file("out")});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find("a.toml:3: threads = 0 is out of range"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("b.toml:2: unknown key \"speed\""), std::string::npos) << result.err;
  EXPECT_FALSE(std::filesystem::exists(folder.file("out")));
}

}  // namespace
}  // namespace raysweep
