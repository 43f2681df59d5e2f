// Claims through the program: from a config to verdicts on the terminal and in files.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/program/program.h"

namespace raysweep {
namespace {

/// Rays are the same in every launch, so that no verdict here depends on a clock.
const std::string head =
    "# How many rays do four samples take?\nexperiment = \"samples\"\n[sweep]\nscheduler = \"serial\"\n"
    "width = 16\nheight = 16\nsubpixels = [1, 4]\n[measure]\nlaunches = 1\nseconds = 0\ntwins = 0\n";

std::string claim(const std::string& id, const std::string& expect) {
  return "[[claim]]\nid = \"" + id + "\"\ntext = \"four samples take " + id +
         " the rays\"\nrule = \"ratio\"\nquantity = \"rays\"\nof = { subpixels = 4 }\nto = { subpixels = 1 "
         "}\nexpect = " +
         expect + "\nwhy = \"rays are counted\"\n";
}

TEST(claims, are_judged_by_run_and_by_report_alike) {
  const TemporaryFolder folder;
  const std::string config =
      folder.write("a.toml", head + claim("four-times", "[3.5, 4.5]") + claim("twice", "[1, 2]"));
  const ProgramResult run = run_program({"run", config, "--out", folder.file("out")});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("four-times: four samples take four-times the rays"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("here: reproduced: "), std::string::npos);
  EXPECT_NE(run.out.find("here: not reproduced: "), std::string::npos);
  EXPECT_NE(run.out.find("why: rays are counted"), std::string::npos);
  const std::string before = read_file(folder.file("out/report.json"));
  const auto json = nlohmann::json::parse(before);
  EXPECT_EQ(json.at("question"), "How many rays do four samples take?");
  EXPECT_EQ(json.at("claims").at(0).at("ours").at("verdict"), "reproduced");
  EXPECT_EQ(json.at("claims").at(0).at("published").at("verdict"), "not in a table");
  EXPECT_EQ(json.at("claims").at(1).at("ours").at("verdict"), "not reproduced");
  EXPECT_EQ(run_program({"report", folder.file("out")}).exit_code, 0);
  EXPECT_EQ(read_file(folder.file("out/report.json")), before) << "byte for byte from the records";
}

TEST(claims, of_another_config_can_be_judged_on_a_finished_run) {
  const TemporaryFolder folder;
  const std::string config = folder.write("a.toml", head);
  ASSERT_EQ(run_program({"run", config, "--out", folder.file("out")}).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder.file("out/tables/claims.md")));
  const std::string later = folder.write("b.toml", head + claim("twice", "[1, 2]"));
  const ProgramResult report = run_program({"report", folder.file("out"), "--claims", later, "--json"});
  ASSERT_EQ(report.exit_code, 0) << report.err;
  EXPECT_EQ(nlohmann::json::parse(report.out).at(0).at("claims").at(0).at("ours").at("verdict"),
            "not reproduced");
  EXPECT_FALSE(read_file(folder.file("out/tables/claims.csv")).empty());
  const std::string other =
      folder.write("c.toml", "experiment = \"other\"\n[sweep]\nscheduler = \"serial\"\n");
  const ProgramResult refused = run_program({"report", folder.file("out"), "--claims", other});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("c.toml: its claims are about experiment \"other\""), std::string::npos)
      << refused.err;
}

TEST(claims, that_are_wrong_are_told_before_anything_runs) {
  const TemporaryFolder folder;
  const std::string config = folder.write("a.toml", head + "[[claim]]\nid = \"x\"\nrule = \"sine\"\n");
  const ProgramResult run = run_program({"run", config, "--out", folder.file("out")});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("a.toml:14: unknown rule \"sine\""), std::string::npos) << run.err;
  EXPECT_FALSE(std::filesystem::exists(folder.file("out")));
}

}  // namespace
}  // namespace raysweep
