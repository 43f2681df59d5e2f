// From a run's folder to verdicts and report.json.
#include "results/judged_run.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "results/report_data.h"
#include "results/tables/write_file.h"
#include "tests/results/make_record.h"

namespace raysweep {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// "two threads are 1.8 times as fast as one, or more", printed as 1.9.
ClaimSheet sheet_of_two_threads() {
  Claim claim;
  claim.id = "two";
  claim.text = "two threads are nearly twice as fast";
  claim.quantity = "fps";
  claim.where = {{"scheduler", {"omp_static"}}};
  claim.of = {{"threads", "2"}};
  claim.to = {{"threads", "1"}};
  claim.expect[""] = {"1.8", ""};
  claim.why = "because";
  PublishedTable table{"a.csv",
                       "fps",
                       1,
                       {"threads"},
                       "first_row",
                       {6, 12},
                       {{{{"threads", "1"}, {"scheduler", "omp_static"}}, "10.0"},
                        {{{"threads", "2"}, {"scheduler", "omp_static"}}, "19.0"},
                        {{{"threads", "8"}, {"scheduler", "omp_static"}}, "50.0"}}};
  return {"Do they?", "raysweep run a.toml", {claim}, table};
}

class judged_run : public testing::Test {
 protected:
  judged_run() { fs::create_directories(folder_); }
  ~judged_run() override { fs::remove_all(folder_); }

  /// A run of one and two threads, the latter `speedup` times as fast, in seven rounds.
  void write_run(double speedup, const ClaimSheet& sheet) {
    std::string lines;
    nlohmann::json plan{{"experiment", "x"}, {"title", "t"}, {"interval", 0.02}};
    for (int round = 0; round < 7; ++round) {
      for (const int threads : {1, 2}) {
        const double noise = 1 + 0.002 * ((round + threads) % 3);
        Record r = make_record("omp_static", threads, round, noise / (threads == 1 ? 1 : speedup));
        lines += to_line(r) + "\n";
        if (round == 0) plan["cells"].push_back(to_json(make_record("omp_static", threads, 0, 0)));
      }
    }
    add_to_plan(plan, sheet);
    write_file(folder_ / "plan.json", plan.dump());
    write_file(folder_ / "records.jsonl", lines);
  }

  JudgedRun judge() const { return judge_run(folder_, read_run(folder_)); }

  void report() const {
    const RunData data = read_run(folder_);
    write_report(folder_, judge_run(folder_, data),
                 write_tables(data.rows, data.context, folder_ / "tables"));
  }

  const fs::path folder_ = fs::temp_directory_path() / ("raysweep_judged_" + std::to_string(getpid()));
};

TEST_F(judged_run, records_that_contradict_a_claim_get_the_contrary_verdict) {
  write_run(1.95, sheet_of_two_threads());
  EXPECT_EQ(judge().claims.at(0).our_verdict(), "reproduced");
  write_run(1.4, sheet_of_two_threads());
  const JudgedRun run = judge();
  EXPECT_EQ(run.claims.at(0).our_verdict(), "not reproduced");
  EXPECT_EQ(run.claims.at(0).published_verdict(), "holds in the source");
}

TEST_F(judged_run, a_report_made_twice_has_the_same_bytes) {
  write_run(1.95, sheet_of_two_threads());
  report();
  std::map<std::string, std::string> first;
  for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
    if (entry.is_regular_file()) first[entry.path()] = text_of(entry.path());
  }
  EXPECT_TRUE(first.contains(folder_ / "report.json"));
  EXPECT_TRUE(first.contains(folder_ / "tables/claims.md"));
  EXPECT_TRUE(first.contains(folder_ / "tables/published.csv"));
  for (const auto& [file, text] : first) {
    if (file.find("plan.json") == std::string::npos && file.find("records") == std::string::npos)
      fs::remove(file);
  }
  report();
  for (const auto& [file, text] : first) EXPECT_EQ(text_of(file), text) << file;
}

TEST_F(judged_run, its_report_has_all_that_a_page_needs) {
  write_run(1.95, sheet_of_two_threads());
  report();
  const auto json = nlohmann::json::parse(text_of(folder_ / "report.json"));
  EXPECT_EQ(json.at("schema"), 1);
  EXPECT_EQ(json.at("question"), "Do they?");
  EXPECT_EQ(json.at("command"), "raysweep run a.toml");
  EXPECT_EQ(json.at("machine"), (nlohmann::json{{"host", "host"}, {"cpu", "cpu"}, {"cores", 2}, {"pus", 4}}));
  ASSERT_EQ(json.at("rows").size(), 2u);
  const auto& row = json["rows"][1];
  EXPECT_EQ(row.at("factors").at("threads"), "2");
  EXPECT_NEAR(row.at("values").at("speedup_one").at("value").get<double>(), 1.95, 0.02);
  EXPECT_EQ(row.at("samples").at("fps").size(), 7u);
  const auto& claim = json.at("claims").at(0);
  EXPECT_EQ(claim.at("rule"),
            "fps at threads 2 by that at threads 1; where scheduler omp_static: expected at least 1.8");
  EXPECT_EQ(claim.at("ours").at("verdict"), "reproduced");
  EXPECT_EQ(claim.at("ours").at("groups").at(0).at("expected_low"), 1.8);
  EXPECT_TRUE(claim.at("ours").at("groups").at(0).at("expected_high").is_null());
  EXPECT_EQ(claim.at("published").at("groups").at(0).at("value"), 1.9);
  EXPECT_EQ(json.at("tables").at(0).at("name"), "scaling");
  EXPECT_EQ(json.at("tables").back().at("name"), "published");
}

TEST_F(judged_run, printed_numbers_stand_beside_ours_each_by_its_own_first_line) {
  write_run(1.95, sheet_of_two_threads());
  const JudgedRun run = judge();
  ASSERT_EQ(run.published.size(), 3u);
  EXPECT_EQ(run.published[1].printed, "19.0");
  EXPECT_DOUBLE_EQ(run.published[1].printed_normalised.value(), 1.9);
  EXPECT_NEAR(run.published[1].ours_normalised.value().value, 1.95, 0.02);
  EXPECT_TRUE(run.published[1].ours_normalised->interval);
  EXPECT_FALSE(run.published[2].ours) << "eight threads were not measured";
  EXPECT_FALSE(run.published[2].ours_normalised);
}

TEST_F(judged_run, other_claims_can_be_judged_later) {
  write_run(1.95, sheet_of_two_threads());
  ClaimSheet other = sheet_of_two_threads();
  other.question = "Another?";
  other.claims[0].expect[""] = {"2.5", ""};
  const JudgedRun run = judge_run(folder_, read_run(folder_), other);
  EXPECT_EQ(run.claims.at(0).our_verdict(), "not reproduced");
  EXPECT_EQ(run.sheet.question, "Do they?") << "what was run is what it was";
}

TEST_F(judged_run, runs_without_claims_are_reported_without_verdicts) {
  write_run(1.95, sheet_of_two_threads());
  report();
  write_run(1.95, {});
  report();
  EXPECT_EQ(verdicts_as_text(judge()), "");
  EXPECT_FALSE(fs::exists(folder_ / "tables/claims.md")) << "what is no longer claimed must not stay";
  EXPECT_FALSE(fs::exists(folder_ / "tables/published.csv"));
  const auto json = nlohmann::json::parse(text_of(folder_ / "report.json"));
  EXPECT_TRUE(json.at("claims").empty());
  EXPECT_TRUE(json.at("published").is_null());
  EXPECT_EQ(json.at("command"), "raysweep run config.toml");
}

TEST_F(judged_run, the_machine_of_kinds_whose_records_do_not_tell_is_in_its_file) {
  write_run(1.95, {});
  write_file(
      folder_ / "plan.json",
      R"({"kind": "kernel", "experiment": "x", "title": "t", "rounds": 1, "cells": [], "left_out": []})");
  write_file(folder_ / "records.jsonl", "");
  EXPECT_FALSE(judge_run(folder_, read_kernel_run(folder_)).machine.counts.is_known());
  write_file(folder_ / "machine.json", R"({"host": "h", "cpu": "c", "cores": 6, "pus": 12})");
  EXPECT_EQ(judge_run(folder_, read_kernel_run(folder_)).machine.counts.pus, 12);
}

TEST_F(judged_run, the_terminal_shows_a_verdict_with_its_numbers) {
  write_run(1.4, sheet_of_two_threads());
  const std::string text = verdicts_as_text(judge());
  EXPECT_EQ(text.substr(0, 43), "\ntwo: two threads are nearly twice as fast\n");
  EXPECT_NE(text.find("in the source: holds in the source: 1.9 ["), std::string::npos) << text;
  EXPECT_NE(text.find("here: not reproduced: 1.4 ["), std::string::npos) << text;
  EXPECT_NE(text.find("why: because"), std::string::npos) << text;
}

}  // namespace
}  // namespace raysweep
