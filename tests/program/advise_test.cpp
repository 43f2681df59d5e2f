// `raysweep advise` and `raysweep render --method auto`, as a user and a script call them.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/program/program.h"

namespace raysweep {
namespace {

ProgramResult advise(std::vector<std::string> more) {
  std::vector<std::string> command{"advise",   "chair-ball", "--width",   "16",
                                   "--height", "12",         "--seconds", "0"};
  command.insert(command.end(), more.begin(), more.end());
  return run_program(command);
}

TEST(advise, gives_one_document_in_which_predictions_bound_measurements) {
  const ProgramResult result = advise({"--json", "--hit-tolerance", "1e-4"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out, nullptr, false);
  ASSERT_FALSE(json.is_discarded()) << result.out;
  EXPECT_EQ(json["scene"], "chair-ball");
  EXPECT_EQ(json["hit_tolerance"], 1e-4);
  ASSERT_EQ(json["rows"].size(), 6u);
  for (const auto& row : json["rows"]) {
    EXPECT_GE(row["predicted"], row["measured"]) << row;
    EXPECT_GT(row["ns_per_ray"], 0);
    EXPECT_GE(row["rounds"], 7);
    EXPECT_EQ(row["promises"], row["predicted"] <= json["hit_tolerance"]) << row;
    EXPECT_EQ(row["keeps"], row["promises"] || row["shown"] <= json["hit_tolerance"]) << row;
    EXPECT_GE(row["shown"], row["measured"]) << row;
  }
  EXPECT_EQ(json["study"].size(), 30u) << "fifteen methods in two precisions";
  EXPECT_TRUE(json["choice"].contains("method"));
}

TEST(advise, chooses_the_quickest_row_that_keeps_the_tolerance) {
  const auto json = nlohmann::json::parse(advise({"--json", "--hit-tolerance", "1e-8"}).out, nullptr, false);
  ASSERT_FALSE(json.is_discarded());
  const nlohmann::json* quickest = nullptr;
  for (const auto& row : json["rows"])
    if (row["keeps"] && (!quickest || row["ns_per_ray"] < (*quickest)["ns_per_ray"])) quickest = &row;
  ASSERT_TRUE(quickest);
  EXPECT_EQ((*quickest)["verdict"], "chosen");
  EXPECT_EQ(json["choice"]["method"], (*quickest)["method"]);
  EXPECT_EQ(json["choice"]["precision"], "double");
}

TEST(advise, fails_with_a_sentence_where_no_method_will_do) {
  const ProgramResult result = advise({"--hit-tolerance", "1e-18"});
  EXPECT_EQ(result.exit_code, 1) << result.err;
  EXPECT_NE(result.out.find("no method can promise a hit tolerance of 1e-18; the smallest that can be is"),
            std::string::npos)
      << result.out;
}

TEST(advise, refuses_what_is_no_tolerance) {
  const ProgramResult result = advise({"--hit-tolerance", "-1"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.err,
            "raysweep: hit-tolerance = -1 is not possible: a number above 0 and up to 1, the share of the "
            "scene's size by which hit points may be off\n");
}

/// The hash of a small picture.
std::string hash_of(std::vector<std::string> more) {
  const TemporaryFolder folder;
  std::vector<std::string> command{"render", "--json",   "--scene", "chair-ball", "--width",
                                   "32",     "--height", "24",      "--out",      folder.file("picture.png")};
  command.insert(command.end(), more.begin(), more.end());
  const ProgramResult result = run_program(command);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return nlohmann::json::parse(result.out, nullptr, false).value("image_hash", "");
}

TEST(render_auto, makes_the_picture_of_what_it_says_that_it_chose) {
  const TemporaryFolder folder;
  const ProgramResult result =
      run_program({"render", "--json", "--scene", "chair-ball", "--width", "32", "--height", "24", "--method",
                   "auto", "--hit-tolerance", "1e-8", "--out", folder.file("picture.png")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out, nullptr, false);
  ASSERT_FALSE(json.is_discarded()) << result.out;
  EXPECT_EQ(json["chosen"]["precision"], "double");
  EXPECT_LE(json["chosen"]["predicted"], 1e-8);
  EXPECT_EQ(json["chosen"]["hit_tolerance"], 1e-8);
  const std::string method = json["chosen"]["method"];
  EXPECT_EQ(json["image_hash"], hash_of({"--method", method, "--precision", "double"}));
}

TEST(render_auto, tells_people_what_it_chose_and_why) {
  const TemporaryFolder folder;
  const ProgramResult result = run_program({"render", "--scene", "chair-ball", "--width", "32", "--height",
                                            "24", "--method", "auto", "--out", folder.file("picture.png")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(
      result.out.rfind("method moller_trumbore in float: the cheapest that can promise hit points within "
                       "0.0001 of the scene's size; it promises ",
                       0),
      0u)
      << result.out;
}

TEST(render_auto, refuses_before_it_renders) {
  const TemporaryFolder folder;
  const auto refused = [&](std::vector<std::string> more) {
    std::vector<std::string> command{"render", "--scene", "chair-ball", "--out", folder.file("picture.png")};
    command.insert(command.end(), more.begin(), more.end());
    const ProgramResult result = run_program(command);
    EXPECT_EQ(result.exit_code, 2) << result.out;
    EXPECT_EQ(folder.entries(), 0u);
    return result.err;
  };
  EXPECT_EQ(refused({"--hit-tolerance", "1e-4"}),
            "raysweep: --hit-tolerance 0.0001: chooses a method, which only --method auto asks for\n");
  EXPECT_EQ(refused({"--method", "auto", "--hit-tolerance", "2"}),
            "raysweep: hit-tolerance = 2 is not possible: a number above 0 and up to 1, the share of the "
            "scene's size by which hit points may be off\n");
  EXPECT_NE(refused({"--method", "auto", "--core", "wide", "--hit-tolerance", "1e-12"})
                .find("no method can promise a hit tolerance of 1e-12; the smallest that can be is"),
            std::string::npos);
}

TEST(render_auto, is_for_one_picture_and_not_for_sweeps) {
  const TemporaryFolder folder;
  const std::string config =
      folder.write("auto.toml",
                   "# ?\nexperiment = \"x\"\n[scene]\nname = \"chair-ball\"\nmodes = [\"low\"]\n[sweep]\n"
                   "method = [\"auto\"]\n");
  const ProgramResult result = run_program({"run", config, "--dry-run"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find("method = \"auto\" is for `raysweep render`, which chooses by the scene"),
            std::string::npos)
      << result.err;
}

}  // namespace
}  // namespace raysweep
