// Printed tables as observations, and what Morozov 2011's table 3 says of its own text.
#include "results/claims/published_table.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "results/claims/judge.h"
#include "results/scaling.h"
#include "tests/results/make_record.h"

namespace raysweep {
namespace {

PublishedTable morozov_table_3() {
  PublishedTable table;
  table.quantity = "fps";
  table.machine = {6, 12};
  table.rows = {"threads"};
  table.numbers = read_published(
      std::filesystem::path(RAYSWEEP_SOURCE_DIR) / "results/published/morozov2011_table3_openmp_fps.csv",
      {{"threads"}, "{}", {"mode"}, {}, {{"scheduler", "omp_static"}}}, "fps");
  return table;
}

/// Numbers of a file with this text, or what is said of it.
std::string read(const std::string& text, const PublishedLayout& layout) {
  const auto file = std::filesystem::temp_directory_path() / ("raysweep_table_" + std::to_string(getpid()));
  std::ofstream(file) << text;
  std::string told;
  try {
    for (const PrintedNumber& number : read_published(file, layout, "fps")) {
      for (const auto& [name, value] : number.factors) told += name + "=" + value + " ";
      told += number.text + "\n";
    }
  } catch (const RecordError& error) {
    told = std::string(error.what()).substr(file.string().size());
  }
  std::filesystem::remove(file);
  return told;
}

TEST(published_tables, name_the_factors_of_every_number) {
  EXPECT_EQ(read("threads,low,very_hard\n1,2.5,3\n", {{"threads"}, "{}", {"mode"}, {}, {{"scheduler", "x"}}}),
            "mode=low scheduler=x threads=1 2.5\nmode=very_hard scheduler=x threads=1 3\n");
  EXPECT_EQ(
      read("n,min_valarray,min_vec4\n10,5,6\n", {{"iterations"}, "{}", {"statistic", "vector"}, {}, {}}),
      "iterations=10 statistic=min vector=valarray 5\niterations=10 statistic=min vector=vec4 6\n");
  EXPECT_EQ(read("side,serial,threads_4\n128,5,6\n",
                 {{"width"},
                  "{}",
                  {},
                  {{"serial", {{"scheduler", "serial"}}}, {"threads_4", {{"threads", "4"}}}},
                  {}}),
            "scheduler=serial width=128 5\nthreads=4 width=128 6\n");
  EXPECT_EQ(read("chunks,low\n3,5\n", {{"chunk"}, "{}/thread", {"mode"}, {}, {}}),
            "chunk=3/thread mode=low 5\n");
  EXPECT_EQ(read("width,depth,fps\n640,16,36\n", {{"width", "depth"}, "{}", {}, {}, {}}),
            "depth=16 width=640 36\n");
  EXPECT_EQ(read("threads,low\n1,\n2,5\n", {{"threads"}, "{}", {"mode"}, {}, {}}), "mode=low threads=2 5\n")
      << "an empty field is no number";
}

TEST(published_tables, that_are_none_are_told_with_their_line) {
  const PublishedLayout modes{{"threads"}, "{}", {"mode"}, {}, {}};
  EXPECT_EQ(read("threads,low\n1,2,3\n", modes), ":2: not such a table: 3 values under 2 columns");
  EXPECT_EQ(read("threads,low\n1,fast\n", modes), ":2: not such a table: \"fast\" is no number");
  EXPECT_EQ(read("threads\n1\n", modes), ":1: not such a table: 1 columns, where the first 1 are factors");
  EXPECT_EQ(read("threads,low\n", modes), ": has no numbers");
  EXPECT_EQ(read("threads,low\n1,2\n", {{"threads"}, "{}", {}, {}, {}}),
            ":1: not such a table: column \"low\" has no name: give `columns` or `rename`");
  EXPECT_EQ(
      read("n,min\n1,2\n", {{"n"}, "{}", {"statistic", "vector"}, {}, {}}),
      ":1: not such a table: column \"min\" has not one value for each of statistic, vector; `rename` says "
      "what it is");
}

TEST(published_tables, are_unsure_by_half_a_unit_of_the_last_digit) {
  EXPECT_DOUBLE_EQ(half_unit_of("6.888"), 0.0005);
  EXPECT_DOUBLE_EQ(half_unit_of("36"), 0.5);
  EXPECT_DOUBLE_EQ(half_unit_of("2.5e-3"), 0.00005);
  PublishedTable table;
  table.scale = 1e-6;
  table.numbers = {{{}, "250"}, {{}, "300"}};
  table.quantity = "frame_seconds";
  const auto list = observations_of(table, "frame_seconds").value();
  ASSERT_EQ(list.size(), 1u) << "of what is printed twice the first counts";
  EXPECT_DOUBLE_EQ(list[0].value.value, 250e-6);
  EXPECT_DOUBLE_EQ(list[0].half_unit, 0.5e-6);
}

TEST(published_tables, of_times_are_tables_of_frames_a_second_too) {
  PublishedTable table;
  table.quantity = "frame_seconds";
  table.scale = 1e-3;
  table.numbers = {{{}, "40"}};
  const auto fps = observations_of(table, "fps").value();
  EXPECT_DOUBLE_EQ(fps.at(0).value.value, 25);
  EXPECT_NEAR(fps.at(0).half_unit, 25 * 0.5 / 40, 1e-12) << "relative errors stay";
  EXPECT_FALSE(observations_of(table, "speedup"));
}

class morozov : public testing::Test {
 protected:
  static SideJudgement judge_table(Claim claim) {
    claim.quantity = "fps";
    return judge(claim, observations_of(morozov_table_3(), "fps").value(), {6, 12});
  }
  static Claim on_threads(Rule rule) {
    Claim claim;
    claim.rule = rule;
    claim.key = "threads";
    return claim;
  }
};

TEST_F(morozov, is_near_linear_to_six_threads) {
  Claim claim = on_threads(Rule::linear);
  claim.over = {"1", "6"};
  EXPECT_EQ(judge_table(claim).verdict, ClaimVerdict::holds);
  claim.over = {"1", "12"};
  EXPECT_EQ(judge_table(claim).verdict, ClaimVerdict::fails) << "not to twelve";
}

TEST_F(morozov, gains_a_quarter_by_hyper_threading_in_every_mode) {
  Claim claim;
  claim.of = {{"threads", "pus"}};
  claim.to = {{"threads", "cores"}};
  claim.expect[""] = {"1.24", "1.28"};
  const SideJudgement side = judge_table(claim);
  EXPECT_EQ(side.verdict, ClaimVerdict::holds) << side.sentence;
  ASSERT_EQ(side.groups.size(), 4u);
  EXPECT_NEAR(side.groups[0].value.value(), 1.25, 0.005);
  EXPECT_NEAR(side.groups[1].value.value(), 1.27, 0.005);
}

TEST_F(morozov, peaks_at_twelve_threads_but_for_a_trifle_in_one_mode) {
  Claim claim = on_threads(Rule::argmax);
  claim.expected_values = {"pus"};
  const SideJudgement side = judge_table(claim);
  EXPECT_EQ(side.verdict, ClaimVerdict::fails) << "hard prints 4.131 at 12 threads, and 4.134 at 22";
  for (const GroupJudgement& group : side.groups) EXPECT_EQ(group.holds, group.group.at("mode") != "hard");
  claim.within = 0.01;
  EXPECT_EQ(judge_table(claim).verdict, ClaimVerdict::holds);
  claim.expected_values = {"cores"};
  EXPECT_EQ(judge_table(claim).verdict, ClaimVerdict::fails);
}

TEST_F(morozov, drops_at_seven_and_at_thirteen) {
  Claim claim = on_threads(Rule::step);
  claim.expect[""] = {"", "1", false, true};
  for (const char* at : {"7", "13"}) {
    claim.at = at;
    const SideJudgement side = judge_table(claim);
    EXPECT_EQ(side.verdict, ClaimVerdict::holds) << at << ": " << side.sentence;
  }
  claim.at = "6";
  EXPECT_EQ(judge_table(claim).verdict, ClaimVerdict::fails);
}

TEST_F(morozov, never_prints_the_speedup_of_his_conclusion) {
  Claim claim = on_threads(Rule::argmax);
  claim.rule = Rule::ratio;
  claim.of = {{"threads", "12"}};
  claim.to = {{"threads", "1"}};
  claim.expect[""] = {"7.55", "7.65"};
  claim.holds = "any";
  EXPECT_EQ(judge_table(claim).verdict, ClaimVerdict::fails) << "7.6 is in no column";
}

TEST(published_tables, our_speedups_of_his_printed_fps_are_his_own) {
  std::vector<Record> records, planned;
  for (const PrintedNumber& number : morozov_table_3().numbers) {
    Record r =
        make_record("omp_static", std::stoi(number.factors.at("threads")), 0, 1 / std::stod(number.text));
    r.mode = number.factors.at("mode");
    r.cell += r.mode;
    records.push_back(r);
    if (r.threads == 12) planned.push_back(r);
  }
  const std::pair<const char*, double> of_his[] = {
      {"low", 7.28}, {"middle", 7.44}, {"hard", 7.30}, {"very_hard", 7.49}};
  const auto rows = summarise(records, planned, 0.02);
  ASSERT_EQ(rows.size(), 4u);
  for (size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].cell.mode, of_his[i].first);
    EXPECT_NEAR(rows[i].speedup_one.value().value, of_his[i].second, 0.005) << rows[i].cell.mode;
  }
}

}  // namespace
}  // namespace raysweep
