// A row that another process spoiled says so.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "tests/program/program.h"

namespace raysweep {
namespace {

TEST(load, beside_a_process_that_burns_a_processor_rows_carry_the_reason) {
  const TemporaryFolder folder;
  const std::string config =
      folder.write("x.toml",
                   "experiment = \"x\"\n[scene]\nname = \"studio\"\n[sweep]\nscheduler = \"thread_dynamic\"\n"
                   "threads = \"pus\"\nwidth = 64\nheight = 64\n[measure]\nlaunches = 2\nseconds = 0.3\n");
  const std::jthread burner([](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
    }
  });
  const ProgramResult result = run_program({"run", config, "--out", folder.file("run")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  std::istringstream lines(read_file(folder.file("run/records.jsonl")));
  bool told = false;
  for (std::string line; std::getline(lines, line);)
    told |= !nlohmann::json::parse(line)["state"]["other_processors"].is_null();
  if (!told) GTEST_SKIP() << "this machine does not tell who uses its processors";
  EXPECT_NE(result.out.find("beside other load: up to "), std::string::npos) << result.out;
}

}  // namespace
}  // namespace raysweep
