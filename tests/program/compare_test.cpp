// `raysweep compare`, as a user and a script call it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/program/program.h"

namespace raysweep {
namespace {

class Compare : public testing::Test {
 public:
  TemporaryFolder folder;

  /// A run of small pictures by one thread; its folder.
  [[nodiscard]] std::string measured() const {
    const std::string config =
        folder.write("x.toml",
                     "experiment = \"x\"\n[scene]\nname = \"studio\"\n[sweep]\nscheduler = "
                     "\"thread_static\"\nthreads = 1\nwidth = 48\nheight = 48\n[measure]\nlaunches = "
                     "7\nmax_launches = 7\nseconds = 0.02\n");
    EXPECT_EQ(run_program({"run", config, "--out", folder.file("a")}).exit_code, 0);
    return folder.file("a");
  }

  /// The same run, in which all frames of thread_static took nine times as long more: measured once, so that
  /// what else this machine does makes no difference between the two.
  [[nodiscard]] std::string slowed(const std::string& run) const {
    const std::string copy = folder.file("b");
    std::filesystem::copy(run, copy, std::filesystem::copy_options::recursive);
    std::istringstream lines(read_file(run + "/records.jsonl"));
    std::string text;
    for (std::string line; std::getline(lines, line);) {
      auto r = nlohmann::json::parse(line);
      if (r["scheduler"] == "thread_static") {
        for (auto& frame : r["frame_seconds"]) frame = frame.get<double>() * 10;
      }
      text += r.dump() + "\n";
    }
    (void)folder.write("b/records.jsonl", text);
    return copy;
  }
};

TEST_F(Compare, a_cell_that_became_far_slower_fails_a_script_and_a_run_against_itself_does_not) {
  const std::string a = measured(), b = slowed(a);
  const ProgramResult slower = run_program({"compare", a, b, "--fail-if-slower", "5%"});
  EXPECT_EQ(slower.exit_code, 1) << slower.out;
  EXPECT_NE(slower.out.find("slower in 1 (worst "), std::string::npos) << slower.out;
  EXPECT_EQ(run_program({"compare", a, b, "--fail-if-slower", "95 %"}).exit_code, 0) << "it is not that slow";
  EXPECT_EQ(run_program({"compare", b, a, "--fail-if-slower", "0"}).exit_code, 0) << "faster is no failure";
  const ProgramResult same = run_program({"compare", a, a, "--fail-if-slower", "0", "--json"});
  EXPECT_EQ(same.exit_code, 0);
  const auto document = nlohmann::json::parse(same.out);
  for (const auto& row : document.at("rows")) EXPECT_EQ(row["verdict"], "no difference");
}

TEST_F(Compare, a_script_is_told_where_nothing_could_be_compared) {
  const std::string a = measured(), b = slowed(a);
  const std::string text = read_file(b + "/records.jsonl");
  (void)folder.write("b/records.jsonl", text.substr(0, text.find('\n') + 1));
  EXPECT_EQ(run_program({"compare", a, b}).exit_code, 0);
  const ProgramResult result = run_program({"compare", a, b, "--fail-if-slower", "5%"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.err.find("could not be compared"), std::string::npos) << result.err;
}

TEST_F(Compare, two_cells_of_one_run) {
  const ProgramResult result = run_program({"compare", slowed(measured()), "--cell", "scheduler=serial",
                                            "--cell", "scheduler=thread_static", "--fail-if-slower", "0.5"});
  EXPECT_EQ(result.exit_code, 1) << result.out;
  EXPECT_NE(result.out.find("slower than serial"), std::string::npos) << result.out;
}

TEST_F(Compare, what_cannot_be_compared_is_refused) {
  const std::string a = measured();
  const std::pair<std::vector<std::string>, const char*> wrong[] = {
      {{a}, "name two runs"},
      {{a, a, "--cell", "threads=1"}, "name one run, and --cell twice"},
      {{a, folder.file("none")}, "no run is here"},
      {{a, a, "--fail-if-slower", "fast"}, "a share from 0 to below 1 is possible, such as 5% or 0.05"},
      {{a, "--cell", "scheduler=serial", "--cell", "threads=9"},
       "no cell has threads=9; there is threads = 1"},
      {{folder.file("x.exr"), folder.file("y.exr")}, "x.exr"}};
  for (const auto& [arguments, sentence] : wrong) {
    std::vector<std::string> command{"compare"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const ProgramResult result = run_program(command);
    EXPECT_EQ(result.exit_code, 2) << sentence;
    EXPECT_NE(result.err.find(sentence), std::string::npos) << result.err;
  }
}

TEST_F(Compare, two_pictures) {
  const auto render = [&](const char* name, const char* depth) {
    EXPECT_EQ(run_program({"render", "--scene", "studio", "--width", "32", "--height", "24", "--depth", depth,
                           "--out", folder.file(name)})
                  .exit_code,
              0);
    return folder.file(name);
  };
  const std::string a = render("a.exr", "1"), b = render("b.exr", "4"), again = render("c.exr", "4");
  const auto different = nlohmann::json::parse(run_program({"compare", a, b, "--json"}).out);
  EXPECT_GT(different["rmse"], 0);
  EXPECT_EQ(different["holes"], 0);
  const ProgramResult same = run_program({"compare", b, again});
  EXPECT_NE(same.out.find("equal in every bit"), std::string::npos) << same.out;
  EXPECT_NE(same.out.find("FLIP 0 on average, 0 at the 95th percentile, 0 at most"), std::string::npos)
      << same.out;
}

/// One pixel of 32 × 24 that is white instead of black: one wrong pixel, which the eye at its distance sees
/// smeared over its neighbours.
TEST_F(Compare, of_pictures_tells_wrong_pixels_and_what_is_seen_of_them_and_draws_it) {
  const std::string head =
      "[camera]\nposition = [0, 0, 5]\ntarget = [0, 0, 0]\nfield_of_view = 40\n[materials.m]\ncolour = [1, "
      "1, "
      "1]\nk_ambient = 1\nk_diffuse = 0\nk_specular = 0\n[[objects]]\nshape = \"sphere\"\nmaterial = "
      "\"m\"\ncentre = ";
  const auto render = [&](const char* name, const char* sphere) {
    const std::string scene = folder.write("scene.toml", head + sphere);
    EXPECT_EQ(run_program(
                  {"render", "--scene", scene, "--width", "32", "--height", "24", "--out", folder.file(name)})
                  .exit_code,
              0);
    return folder.file(name);
  };
  // A pixel is 2·5·tan(20°)/24 = 0.152 wide here; the first sphere lies about its centre, the second behind
  // the camera.
  const std::string dot = render("a.exr", "[0.076, 0.076, 0]\nradius = 0.05\n"),
                    none = render("b.exr", "[0.076, 0.076, 90]\nradius = 0.05\n"),
                    map = folder.file("map.png");
  const auto json = nlohmann::json::parse(run_program({"compare", none, dot, "--out", map, "--json"}).out);
  EXPECT_EQ(json["wrong_pixels"], 1);
  EXPECT_EQ(json["differing_pixels"], 1);
  EXPECT_LT(json["flip"]["p95"], json["flip"]["max"]);
  EXPECT_GT(json["flip"]["max"], 0.1);
  EXPECT_LT(json["flip"]["mean"], 0.1);
  EXPECT_TRUE(read_file(map).starts_with("\x89PNG"));
  const std::pair<std::vector<std::string>, const char*> wrong[] = {
      {{"compare", none, dot, "--out", folder.file("map.jpg")}, "the map is written as .png"},
      {{"compare", none, dot, "--out", folder.file("none/map.png")}, "none/map.png"},
      {{"compare", folder.file("a"), folder.file("b"), "--out", map},
       "--out is for pictures; these are runs"}};
  for (const auto& [command, sentence] : wrong) {
    const ProgramResult result = run_program(command);
    EXPECT_EQ(result.exit_code, 2) << sentence;
    EXPECT_NE(result.err.find(sentence), std::string::npos) << result.err;
  }
}

}  // namespace
}  // namespace raysweep
