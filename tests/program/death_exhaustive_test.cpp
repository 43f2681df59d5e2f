// Kills at random moments, many of them.
#include <csignal>
#include <random>

#include "tests/program/death.h"

namespace raysweep {
namespace {

using namespace std::chrono_literals;

TEST_F(Death, fifty_kills_of_parent_or_child_lose_nothing) {
  const std::string config = sweep(20);
  const Cells expected = all_launches(config);
  ASSERT_GT(expected.size(), 100u);
  std::mt19937 random(20);
  std::string before;
  for (int kills = 0; kills < 50; ++kills) {
    Program program({"run", config, "--out", out, kills > 0 ? "--resume" : "--json"});
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 120'000));
    if (random() % 2 == 0) {
      for (const pid_t child : children_of(program.pid())) kill(child, SIGKILL);
      std::this_thread::sleep_for(20ms);  // for the parent to write down what it saw
    }
    program.send(SIGKILL);
    (void)program.wait();
    const std::string after = whole_lines();
    EXPECT_TRUE(after.starts_with(before)) << "a finished launch is gone";
    before = after;
    if (!after.empty()) {
      EXPECT_EQ(run_program({"report", out}).exit_code, 0) << "after kill " << kills;
    }
  }
  EXPECT_LT(valid_launches().size(), expected.size()) << "the run was over before all kills: make it longer";
  const ProgramResult last = run_program({"run", config, "--out", out, "--resume"});
  EXPECT_EQ(last.exit_code, 0) << last.err;
  EXPECT_EQ(valid_launches(), expected) << "the same cells and rounds as an undisturbed run";
}

}  // namespace
}  // namespace raysweep
