// `raysweep peers`, as a user and a script call it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/program/program.h"

namespace raysweep {
namespace {

constexpr const char* without_embree = "there is no Embree to compare with";

ProgramResult small_run(std::vector<std::string> more) {
  std::vector<std::string> command{"peers",
                                   "--width",
                                   "32",
                                   "--height",
                                   "24",
                                   "--rounds",
                                   "6",
                                   "--kinds",
                                   "primary,shadow",
                                   "--seconds",
                                   "0.0005",
                                   "--picture-modes",
                                   "middle",
                                   "--picture-scale",
                                   "0.05",
                                   "--picture-rounds",
                                   "6"};
  command.insert(command.end(), more.begin(), more.end());
  return run_program(command);
}

TEST(peers, without_embree_says_so) {
  if (RAYSWEEP_HAS_EMBREE) GTEST_SKIP() << "it is here";
  const ProgramResult result = small_run({});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find(without_embree), std::string::npos) << result.err;
  EXPECT_EQ(result.out, "");
}

TEST(peers, gives_one_document) {
  if (!RAYSWEEP_HAS_EMBREE) GTEST_SKIP() << without_embree;
  const ProgramResult result = small_run({"--json", "--scene", "chair-ball", "--scene", "cornell-glass"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out, nullptr, false);
  ASSERT_FALSE(json.is_discarded()) << result.out;
  ASSERT_EQ(json["rows"].size(), 12u);
  for (const auto& row : json["rows"]) {
    EXPECT_TRUE(row["kind"] == "primary" || row["kind"] == "shadow") << row;
    EXPECT_TRUE(row["class"] == "single" || row["class"] == "best" || row["class"] == "robust") << row;
    EXPECT_GT(row["ours_mrays"], 0);
    EXPECT_GT(row["embree_mrays"], 0);
    EXPECT_LE(row["low"], row["ratio"]);
    EXPECT_GE(row["high"], row["ratio"]);
    EXPECT_TRUE(row["hits_differ"].is_number_unsigned()) << row;
  }
  ASSERT_EQ(json["pictures"].size(), 2u) << "chair-ball's: one thread and two";
  for (const auto& picture : json["pictures"]) {
    EXPECT_EQ(picture["scene"], "chair-ball");
    EXPECT_EQ(picture["width"], 40);
    EXPECT_LE(picture["low"], picture["ratio"]);
    EXPECT_GT(picture["embree_share"], 0);
    EXPECT_LT(picture["embree_share"], 1);
  }
  EXPECT_NE(result.err.find("cornell-glass: no pictures: it holds glass"), std::string::npos) << result.err;
  EXPECT_EQ(json["builds"].size(), 8u) << "two scenes, two classes, one and two threads";
}

TEST(peers, prints_three_tables) {
  if (!RAYSWEEP_HAS_EMBREE) GTEST_SKIP() << without_embree;
  const ProgramResult result = small_run({});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  for (const char* words : {"one thread", "chair-ball", "Mrays/s", "Pictures: ", "Builds: "})
    EXPECT_NE(result.out.find(words), std::string::npos) << result.out;
}

TEST(peers, refuses_what_it_cannot_compare) {
  const TemporaryFolder folder;
  const std::string no_triangles =
      folder.write("s.toml",
                   "[camera]\nposition = [0, 2, 5]\ntarget = [0, 0, 0]\n[materials.a]\n[[objects]]\nshape = "
                   "\"sphere\"\ncentre = [0, 0, 0]\nradius = 1\nmaterial = \"a\"\n");
  const std::pair<std::vector<std::string>, const char*> wrong[] = {
      {{"--kinds", "secondary"}, "--kinds secondary: unknown; possible: primary, shadow, mirror, diffuse"},
      {{"--rounds", "5"}, "--rounds"},
      {{"--width", "0"}, "--width"},
      {{"--seconds", "nan"}, "seconds = nan is out of range: a number from 0 to 60 is possible"},
      {{"--picture-modes", "huge"}, "no pictures of mode \"huge\"; possible: low, middle, hard, very_hard"},
      {{"--picture-scale", "0"},
       "picture-scale = 0 is out of range: a number above 0 and up to 1 is possible"},
      {{"--picture-rounds", "5"}, "--picture-rounds"},
      {{"--scene", "chair-bell"}, "no scene \"chair-bell\""},
      {{"--scene", no_triangles}, "has no triangles, and peers compares triangles alone"}};
  for (const auto& [arguments, sentence] : wrong) {
    std::vector<std::string> command{"peers"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const ProgramResult result = run_program(command);
    EXPECT_EQ(result.exit_code, 2) << sentence;
    EXPECT_EQ(result.out, "");
    const bool embree_first = !RAYSWEEP_HAS_EMBREE && arguments.front() == "--scene";
    EXPECT_NE(result.err.find(embree_first ? without_embree : sentence), std::string::npos) << result.err;
  }
}

}  // namespace
}  // namespace raysweep
