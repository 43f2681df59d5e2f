// `raysweep doctor`, as a user calls it. What it finds depends on the machine; that it finds it does not.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/program/program.h"

namespace raysweep {
namespace {

TEST(doctor, judges_every_check_in_one_document) {
  const ProgramResult result = run_program({"doctor", "--seconds", "0.2", "--pairs", "6", "--json"});
  EXPECT_EQ(result.exit_code, 0) << "findings are no failures: " << result.err;
  EXPECT_EQ(result.err, "");
  const auto json = nlohmann::json::parse(result.out, nullptr, false);
  ASSERT_FALSE(json.is_discarded()) << result.out;
  EXPECT_EQ(json["findings"].size(), 19u);
  for (const auto& finding : json["findings"]) {
    const std::string state = finding["state"];
    EXPECT_TRUE(state == "good" || state == "bad" || state == "unknown") << finding;
    EXPECT_EQ(state == "bad", finding["advice"] != "") << finding;
  }
  EXPECT_GT(json["timer"]["ticks_per_second"], 0);
  EXPECT_TRUE(json["facts"]["quota"].contains("state"));
  EXPECT_GE(json["watch"]["wall_seconds"], 0.2);
  EXPECT_TRUE(json["verdict"].get<std::string>().ends_with(".")) << json["verdict"];
}

TEST(doctor, ends_its_table_with_one_sentence) {
  const ProgramResult result = run_program({"doctor", "--seconds", "0.1", "--pairs", "0"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  for (const char* check : {"governor", "SMT", "quota", "other load", "frequency"})
    EXPECT_NE(result.out.find(check), std::string::npos) << result.out;
  const size_t last_line = result.out.rfind('\n', result.out.size() - 2) + 1;
  const std::string verdict = result.out.substr(last_line);
  EXPECT_TRUE(verdict.find("to mend before you trust small differences") != std::string::npos ||
              verdict.starts_with("Nothing found"))
      << verdict;
}

TEST(doctor, refuses_a_watch_of_no_or_endless_time) {
  for (const char* seconds : {"-1", "0", "nan", "inf", "1e9"}) {
    const ProgramResult result = run_program({"doctor", "--seconds", seconds});
    EXPECT_EQ(result.exit_code, 2) << seconds;
    EXPECT_NE(result.err.find("is out of range: a number from 0.1 to 3600 is possible"), std::string::npos)
        << result.err;
    EXPECT_EQ(result.out, "");
  }
}

}  // namespace
}  // namespace raysweep
