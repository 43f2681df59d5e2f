// Pixels experiments, as a user runs them.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/program/program.h"

namespace raysweep {
namespace {

const std::string tiny =
    "# Does it run?\nexperiment = \"tiny\"\nkind = \"pixels\"\n[sweep]\nscene = \"studio\"\noffset = [0, "
    "1e4]\n"
    "core = [\"scalar\", \"wide\"]\nmethod = [\"moller_trumbore\", \"woop_watertight\"]\n"
    "[measure]\nscale = 0.0625\nrounds = 2\nseconds = 0\n";
constexpr size_t cells = 2 * (2 * 2 + 2);  // offsets × methods: scalar in both precisions, wide in floats

class PixelsRun : public testing::Test {
 public:
  TemporaryFolder folder;

  [[nodiscard]] ProgramResult run(const std::string& out, std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"run", folder.write("tiny.toml", tiny), "--out", folder.file(out)});
    return run_program(more);
  }
  [[nodiscard]] std::vector<nlohmann::json> records(const std::string& out) const {
    std::vector<nlohmann::json> list;
    std::ifstream in(folder.file(out + "/records.jsonl"));
    for (std::string line; std::getline(in, line);) list.push_back(nlohmann::json::parse(line));
    return list;
  }
};

TEST_F(PixelsRun, leaves_records_tables_and_pictures_of_what_is_wrong) {
  const ProgramResult result = run("a");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("left out: core wide in double"), std::string::npos) << result.out;
  const auto list = records("a");
  ASSERT_EQ(list.size(), 2 * cells) << "two rounds";
  for (const auto& r : list) {
    SCOPED_TRACE(r.dump());
    EXPECT_EQ(r["pixels"], 32 * 32);
    EXPECT_EQ(r["valid"], true);
    EXPECT_GE(r["rays"], 32 * 32);
    EXPECT_EQ(r["seconds"].size(), 1u);
    const std::string cell = r["cell"];
    if (cell.ends_with("scalar/woop_watertight/double")) {
      EXPECT_EQ(r["flip_max"], 0) << "it is the reference";
    }
    if (r["precision"] == "float" && r["offset"] == 1e4) {
      EXPECT_GT(r["wrong_pixels"], 0);
      EXPECT_GT(r["flip_max"], r["flip_mean"]);
    }
  }
  for (const char* file : {"pictures/studio-low-reference.png", "pictures/studio+10000-low-reference.png",
                           "pictures/studio+10000-low-wide-woop_watertight-float-wrong.png",
                           "pictures/studio+10000-low-wide-woop_watertight-float-flip.png",
                           "tables/pixels.md", "tables/pixels.csv", "tables/cells.csv", "machine.json"})
    EXPECT_NE(read_file(folder.file("a/" + std::string(file))), "") << file;
  EXPECT_FALSE(
      std::filesystem::exists(folder.file("a/pictures/studio-low-scalar-woop_watertight-double-wrong.png")));
}

TEST_F(PixelsRun, of_few_samples_is_judged_by_a_reference_of_many) {
  const std::string config =
      "experiment = \"aa\"\nkind = \"pixels\"\n[sweep]\nscene = \"chair-ball\"\ncore = \"wide\"\nprecision = "
      "\"float\"\nmethod = \"moller_trumbore\"\npattern = [\"sobol\", \"grid\"]\nsubpixels = [1, 4, 64]\n"
      "[measure]\nscale = 0.125\nrounds = 1\nseconds = 0\nreference_subpixels = 64\n";
  const ProgramResult result =
      run_program({"run", folder.write("aa.toml", config), "--out", folder.file("a")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  std::map<std::pair<std::string, int>, double> at_edges;
  for (const auto& r : records("a")) {
    EXPECT_EQ(r["reference_subpixels"], 64);
    EXPECT_GT(r["edge_pixels"], 0);
    at_edges[{r["pattern"], r["subpixels"]}] = r["edge_rmse"];
  }
  ASSERT_EQ(at_edges.size(), 6u);
  EXPECT_EQ((at_edges[{"sobol", 1}]), (at_edges[{"grid", 1}])) << "both are the pixel's centre";
  EXPECT_GT((at_edges[{"sobol", 1}]), 2 * (at_edges[{"sobol", 4}]));
  EXPECT_GT((at_edges[{"sobol", 4}]), 10 * (at_edges[{"sobol", 64}])) << "the reference's own samples";
  for (const char* file : {"pictures/chair-ball-low-wide-moller_trumbore-float-grid-4-picture.png",
                           "tables/sampling.md", "tables/sampling.csv", "tables/pixels.md"})
    EXPECT_NE(read_file(folder.file("a/" + std::string(file))), "") << file;
}

TEST_F(PixelsRun, is_taken_up_where_it_ended_and_reported_from_its_records) {
  ASSERT_EQ(run("a").exit_code, 0);
  const std::string file = folder.file("a/records.jsonl"), all = read_file(file);
  size_t end = 0;
  for (int line = 0; line < 9; ++line) end = all.find('\n', end) + 1;
  std::ofstream(file, std::ios::binary)
      << all.substr(0, end + 20);  // in the second round of the first picture
  const ProgramResult resumed = run("a", {"--resume", "--json"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  const auto after = records("a");
  ASSERT_EQ(after.size(), 2 * cells);
  EXPECT_TRUE(read_file(file).starts_with(all.substr(0, end))) << "what was finished is kept";
  std::set<std::string> once;
  for (const auto& r : after) once.insert(r["cell"].get<std::string>() + r["round"].dump());
  EXPECT_EQ(once.size(), 2 * cells);
  EXPECT_EQ(nlohmann::json::parse(resumed.out)[0]["complete"], true);
  const std::string table = read_file(folder.file("a/tables/cells.csv"));
  std::filesystem::remove_all(folder.file("a/tables"));
  EXPECT_EQ(run_program({"report", folder.file("a")}).exit_code, 0);
  EXPECT_EQ(read_file(folder.file("a/tables/cells.csv")), table);
}

TEST_F(PixelsRun, a_dry_run_names_the_cells_and_writes_nothing) {
  const ProgramResult result = run("a", {"--dry-run"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("\nstudio+10000/low/wide/moller_trumbore/float\n"), std::string::npos)
      << result.out;
  EXPECT_FALSE(std::filesystem::exists(folder.file("a")));
}

TEST_F(PixelsRun, what_is_for_pictures_alone_is_refused) {
  const ProgramResult result = run("a", {"--budget", "1"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find("--budget is not for a pixels experiment"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace raysweep
