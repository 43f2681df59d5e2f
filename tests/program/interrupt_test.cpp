// Ctrl-C and kill −9 leave whole records and no child behind; a folder has one run at a time.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "tests/program/processes.h"
#include "tests/program/program.h"

namespace raysweep {
namespace {

using namespace std::chrono_literals;

class Interrupt : public testing::Test {
 public:
  TemporaryFolder folder;
  const std::string config = folder.write("sweep.toml",
                                          "experiment = \"x\"\n[scene]\nmodes = [\"low\"]\n"
                                          "[sweep]\nscheduler = [\"thread_static\", "
                                          "\"thread_dynamic\"]\nthreads = [1, 2]\nwidth = 64\nheight = 64\n"
                                          "[measure]\nlaunches = 1000\nbudget = \"5 min\"\nseconds = 0.01\n");
  const std::string out = folder.file("run"), records = folder.file("run/records.jsonl");

  [[nodiscard]] std::vector<std::string> command(const std::string& extra = {}) const {
    std::vector<std::string> arguments{"run", config, "--out", out};
    if (!extra.empty()) arguments.push_back(extra);
    return arguments;
  }

  /// Lines of records.jsonl; each must be whole JSON if `all_whole`.
  [[nodiscard]] size_t lines(bool all_whole = false) const {
    std::istringstream text(read_file(records));
    std::string line;
    size_t count = 0;
    while (std::getline(text, line)) {
      count++;
      if (all_whole) {
        EXPECT_TRUE(nlohmann::json::accept(line)) << line;
      }
    }
    return count;
  }

  /// Waits until the run has `count` records and a launch is under way; its children.
  [[nodiscard]] std::set<pid_t> children_after(const Program& program, size_t count) const {
    EXPECT_TRUE(becomes_true([&] { return lines() >= count; }));
    std::set<pid_t> children;
    EXPECT_TRUE(becomes_true([&] {
      children = children_of(program.pid());
      return !children.empty();
    }));
    return children;
  }

  static bool all_gone(const std::set<pid_t>& pids) {
    return becomes_true([&] {
      const auto alive = process_parents();
      return std::ranges::none_of(pids, [&](pid_t p) { return alive.contains(p); });
    });
  }
};

TEST_F(Interrupt, ctrl_c_keeps_finished_launches_leaves_no_child_and_says_how_to_go_on) {
  Program program(command());
  const auto children = children_after(program, 3);
  program.send(SIGINT);
  const ProgramResult result = program.wait();
  EXPECT_EQ(result.exit_code, 130);
  EXPECT_NE(result.err.find("finished launches are kept; go on with --resume"), std::string::npos)
      << result.err;
  EXPECT_TRUE(all_gone(children));
  EXPECT_GE(lines(true), 3u);
  EXPECT_TRUE(read_file(records).ends_with('\n'));
  EXPECT_TRUE(std::filesystem::exists(folder.file("run/tables/scaling.csv"))) << "what is there is told";
}

TEST_F(Interrupt, kill_9_of_the_parent_leaves_whole_records_and_no_child) {
  for (int i = 0; i < 5; ++i) {
    std::filesystem::remove_all(out);
    Program program(command());
    const auto children = children_after(program, 1 + static_cast<size_t>(i));
    std::this_thread::sleep_for(3ms * i);  // another moment of the launch each time
    const auto more = children_of(program.pid());
    program.send(SIGKILL);
    EXPECT_EQ(program.wait().exit_code, 128 + SIGKILL);
    EXPECT_TRUE(all_gone(children));
    EXPECT_TRUE(all_gone(more));
    EXPECT_GE(lines(true), 1u);
  }
}

TEST_F(Interrupt, a_killed_run_is_resumed) {
  Program program(command());
  (void)children_after(program, 4);
  program.send(SIGKILL);
  (void)program.wait();
  const size_t before = lines(true);
  EXPECT_EQ(run_program(command()).exit_code, 2) << "not without --resume";
  Program again(command("--resume"));
  EXPECT_TRUE(becomes_true([&] { return lines() >= before + 3; }));
  again.send(SIGTERM);
  EXPECT_EQ(again.wait().exit_code, 130);
  std::set<std::pair<std::string, int>> seen;
  std::istringstream text(read_file(records));
  for (std::string line; std::getline(text, line);) {
    const auto r = nlohmann::json::parse(line);
    EXPECT_TRUE(seen.emplace(r["cell"].get<std::string>(), r["round"].get<int>()).second) << "launched twice";
  }
}

TEST_F(Interrupt, a_second_run_into_the_same_folder_is_refused_while_one_lives) {
  Program first(command());
  (void)children_after(first, 1);
  for (const std::string extra : {"", "--resume"}) {
    const ProgramResult second = run_program(command(extra));
    EXPECT_EQ(second.exit_code, 2);
    EXPECT_NE(second.err.find("another run is writing here (process " + std::to_string(first.pid()) + ")"),
              std::string::npos)
        << second.err;
  }
  first.send(SIGINT);
  EXPECT_EQ(first.wait().exit_code, 130);
}

TEST_F(Interrupt, a_killed_launch_is_a_void_record_and_the_run_fails_at_its_end) {
  const std::string small = folder.write(
      "small.toml",
      "experiment = \"x\"\n[sweep]\nscheduler = \"thread_static\"\nthreads = 2\nwidth = 64\nheight = 64\n"
      "[measure]\nlaunches = 2\nseconds = 0.7\n");
  Program program({"run", small, "--out", out});
  (void)children_after(program, 1);
  ASSERT_TRUE(becomes_true([&] {
    const auto children = children_of(program.pid());
    if (children.empty()) return false;
    std::this_thread::sleep_for(300ms);  // past the serial picture, inside a timed launch
    for (const pid_t child : children) kill(child, SIGKILL);
    return read_file(records).find("killed by signal 9") != std::string::npos;
  }));
  const ProgramResult result = program.wait();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.err.find("launches void; the first: custom · "), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("killed by signal 9"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace raysweep
