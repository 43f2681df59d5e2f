// Accuracy experiments, as a user runs them.
#include <gtest/gtest.h>

#include <cctype>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/program/processes.h"
#include "tests/program/program.h"

namespace raysweep {
namespace {

const std::string head = "# Does it run?\nexperiment = \"tiny\"\nkind = \"accuracy\"\n";
const std::string tiny =
    head +
    "[sweep]\nmethod = [\"moller_trumbore\", \"wald\"]\ncase = [\"W1\", \"D1\"]\nvariant = \"star\"\n"
    "[measure]\ntrials = 50\n";

class AccuracyRun : public testing::Test {
 public:
  TemporaryFolder folder;

  [[nodiscard]] ProgramResult run(const std::string& text, const std::string& out,
                                  std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"run", folder.write("tiny.toml", text), "--out", folder.file(out)});
    return run_program(more);
  }
  [[nodiscard]] std::string in(const std::string& out, const std::string& name) const {
    return read_file(folder.file(out + "/" + name));
  }
  [[nodiscard]] static size_t lines(const std::string& text) {
    return static_cast<size_t>(std::count(text.begin(), text.end(), '\n'));
  }
};

TEST_F(AccuracyRun, leaves_records_of_all_cells_and_tables_and_says_so) {
  const ProgramResult result = run(tiny, "a");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("first difficulty with a false miss"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("variants do not exist: tables/left-out.md"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("what methods promise"), std::string::npos) << result.out;
  const auto plan = nlohmann::json::parse(in("a", "plan.json"));
  const std::string records = in("a", "records.jsonl");
  EXPECT_EQ(lines(records), plan["cells"].size());
  const auto first = nlohmann::json::parse(records.substr(0, records.find('\n')));
  EXPECT_EQ(first["kind"], "accuracy");
  EXPECT_EQ(first["rays"], 50);
  EXPECT_EQ(first["cell"], plan["cells"][0]);
  for (const char* name :
       {"where-failing-float", "false-misses-double", "false-hits-float", "missed-rays-float", "case-W1",
        "case-D1", "variants", "variant-cells", "left-out", "contract", "contract-differences"}) {
    for (const char* suffix : {".md", ".csv"})
      EXPECT_NE(in("a", "tables/" + std::string(name) + suffix), "") << name << suffix;
  }
  EXPECT_EQ(lines(in("a", "tables/cells.csv")), plan["cells"].size() + 1);
  EXPECT_NE(in("a", "machine.json"), "");
  EXPECT_EQ(in("a", "config.toml"), tiny);
}

TEST_F(AccuracyRun, gives_the_same_records_again_and_others_of_another_seed) {
  ASSERT_EQ(run(tiny, "a").exit_code, 0);
  ASSERT_EQ(run(tiny, "b").exit_code, 0);
  ASSERT_EQ(run(tiny, "c", {"--seed", "2"}).exit_code, 0);
  EXPECT_EQ(in("a", "records.jsonl"), in("b", "records.jsonl"));
  EXPECT_NE(in("a", "records.jsonl"), in("c", "records.jsonl"));
}

TEST_F(AccuracyRun, is_told_anew_from_its_records_alone) {
  ASSERT_EQ(run(tiny, "a").exit_code, 0);
  const std::string before = in("a", "tables/variants.md");
  std::filesystem::remove_all(folder.file("a/tables"));
  const ProgramResult report = run_program({"report", folder.file("a")});
  EXPECT_EQ(report.exit_code, 0) << report.err;
  EXPECT_EQ(in("a", "tables/variants.md"), before);
  const ProgramResult json = run_program({"report", folder.file("a"), "--json"});
  const auto document = nlohmann::json::parse(json.out);
  EXPECT_EQ(document[0]["rows"].size(), lines(in("a", "records.jsonl")));
  EXPECT_EQ(document[0]["contract"].size(), 4u) << "two methods in two precisions";
}

TEST_F(AccuracyRun, goes_on_where_it_was_stopped_and_ends_with_the_same_records) {
  ASSERT_EQ(run(tiny, "whole").exit_code, 0);
  ASSERT_EQ(run(tiny, "cut").exit_code, 0);
  const std::string all = in("whole", "records.jsonl");
  // After the tenth record, in the middle of the eleventh.
  size_t end = 0;
  for (int i = 0; i < 10; ++i) end = all.find('\n', end) + 1;
  std::ofstream(folder.file("cut/records.jsonl"), std::ios::binary) << all.substr(0, end + 100);
  EXPECT_EQ(run(tiny, "cut").exit_code, 2) << "without --resume a folder with a run is refused";
  const ProgramResult resumed = run(tiny, "cut", {"--resume"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_EQ(in("cut", "records.jsonl"), all);
  const ProgramResult other = run(tiny, "cut", {"--resume", "--seed", "3"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_NE(other.err.find("was made from another config"), std::string::npos) << other.err;
}

TEST_F(AccuracyRun, ctrl_c_keeps_finished_cells_and_says_how_to_go_on) {
  const std::string config =
      folder.write("long.toml", head + "[sweep]\ncase = \"W1\"\n[measure]\ntrials = 30000\n");
  const std::string out = folder.file("long");
  Program program({"run", config, "--out", out});
  ASSERT_TRUE(becomes_true([&] { return !read_file(out + "/records.jsonl").empty(); }));
  program.send(SIGINT);
  const ProgramResult result = program.wait();
  EXPECT_EQ(result.exit_code, 130);
  EXPECT_NE(result.err.find("are finished and kept; go on with --resume --out " + out), std::string::npos)
      << result.err;
  const std::string kept = read_file(out + "/records.jsonl");
  EXPECT_TRUE(kept.ends_with('\n'));
  const ProgramResult resumed = run_program({"run", config, "--out", out, "--resume"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  const std::string all = read_file(out + "/records.jsonl");
  EXPECT_TRUE(all.starts_with(kept)) << "finished cells are not run again";
  EXPECT_EQ(lines(all), nlohmann::json::parse(read_file(out + "/plan.json"))["cells"].size());
}

TEST_F(AccuracyRun, a_dry_run_names_the_cells_and_writes_nothing) {
  const size_t before = folder.entries() + 1;  // the config
  const ProgramResult result = run(tiny, "dry", {"--dry-run"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("\nwald/division=late/float/W1/4096\n"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("left out: wald order=weights_first float: the method looks for the point first"),
            std::string::npos)
      << result.out;
  EXPECT_NE(result.out.find("\nAbout "), std::string::npos) << result.out;
  EXPECT_EQ(folder.entries(), before);
}

TEST_F(AccuracyRun, bad_configs_are_refused_whole_with_file_line_and_possible_values) {
  const auto refused = [&](const std::string& text, const std::string& sentence,
                           const std::vector<std::string>& more = {}) {
    const ProgramResult result = run(text, "bad", more);
    EXPECT_EQ(result.exit_code, 2) << result.err;
    EXPECT_NE(result.err.find(sentence), std::string::npos) << "said: " << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder.file("bad")));
  };
  refused(head + "[sweep]\nmethod = \"wlad\"\nvariant = \"full\"\n",
          "tiny.toml:5: unknown method \"wlad\"; built here: moller_trumbore, ");
  refused(head + "[sweep]\nmethod = \"wlad\"\nvariant = \"full\"\n",
          "tiny.toml:6: unknown variant \"full\"; possible: base, star, product");
  refused("experiment = \"x\"\nkind = \"kernels\"\n",
          "tiny.toml:2: unknown kind \"kernels\"; built here: picture, accuracy, kernel, pixels");
  refused(tiny, "--budget is not for an accuracy experiment", {"--budget", "1"});
}

TEST_F(AccuracyRun, is_not_compared_as_if_it_were_of_pictures) {
  ASSERT_EQ(run(tiny, "a").exit_code, 0);
  const ProgramResult result = run_program({"compare", folder.file("a"), folder.file("a")});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find("a run of kind \"accuracy\", where one of pictures is needed"), std::string::npos)
      << result.err;
}

TEST_F(AccuracyRun, runs_beside_pictures_each_in_a_folder_of_its_own) {
  const std::string picture = folder.write(
      "p.toml",
      "experiment = \"p\"\n[sweep]\nscheduler = \"serial\"\nthreads = 1\nwidth = 32\nheight = 32\n"
      "[measure]\nlaunches = 1\nseconds = 0.01\ntwins = 0\n");
  const ProgramResult result =
      run_program({"run", picture, folder.write("tiny.toml", tiny), "--out", folder.file("both"), "--json"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  ASSERT_EQ(json.size(), 2u);
  EXPECT_EQ(json[0]["folder"], folder.file("both/p"));
  EXPECT_EQ(json[1]["folder"], folder.file("both/tiny"));
  EXPECT_EQ(json[1]["complete"], true);
}

TEST(list_cases, tells_title_source_and_difficulties_of_each) {
  const auto cases = nlohmann::json::parse(run_program({"list", "cases", "--json"}).out);
  ASSERT_EQ(cases[0].at("name"), "W1");
  EXPECT_EQ(cases[0].at("title"), "shared edge of a closed mesh");
  EXPECT_EQ(cases[0].at("source"), "Woop, Benthin & Wald 2013");
  EXPECT_EQ(cases[0].at("difficulties").size(), 5u);
}

TEST(list_cases, has_the_whole_catalogue_each_case_once_and_tests_named_after_those_of_the_tracer) {
  std::multiset<std::string> ids;
  for (const auto& one : nlohmann::json::parse(run_program({"list", "cases", "--json"}).out)) {
    const std::string id = one.at("name");
    ids.insert(id);
    EXPECT_EQ(one.at("available"), true) << id;
    EXPECT_NE(one.at("summary"), "") << id;
    if (!one.contains("checked_in")) continue;
    const std::string test = read_file(RAYSWEEP_SOURCE_DIR "/" + one["checked_in"].get<std::string>());
    std::string name = id + "_";
    name[0] = static_cast<char>(std::tolower(name[0]));
    EXPECT_NE(test.find(name), std::string::npos) << id;
  }
  for (const auto& [letter, count] :
       {std::pair("W", 8), {"S", 4}, {"F", 3}, {"D", 5}, {"N", 8}, {"P", 3}, {"V", 2}, {"I", 1}}) {
    for (int i = 1; i <= count; ++i) EXPECT_EQ(ids.count(letter + std::to_string(i)), 1u) << letter << i;
  }
}

}  // namespace
}  // namespace raysweep
