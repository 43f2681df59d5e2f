#include "results/noise_floor.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "results/run_data.h"
#include "results/statistics/trimmed_mean.h"
#include "tests/results/make_record.h"
#include "tests/results/statistics/simulated.h"

namespace raysweep {
namespace {

TEST(noise_floor, is_what_comparing_a_cell_with_itself_stays_under_95_times_of_100) {
  for (const std::string& kind : simulated_kinds) {
    Simulated draw(kind);
    const NoiseFloor floor = noise_floor(draw.pairs(2000), 7);
    int under = 0;
    constexpr int trials = 4000;
    for (int i = 0; i < trials; ++i) under += std::abs(trimmed_mean(draw.pairs(7)).mean) < *floor.log_ratio;
    EXPECT_NEAR(under / double(trials), 0.95, 0.015) << kind;
  }
}

TEST(noise_floor, sinks_with_more_launches) {
  const auto pairs = Simulated("normal").pairs(60);
  EXPECT_NEAR(*noise_floor(pairs, 28).log_ratio / *noise_floor(pairs, 7).log_ratio, 0.5, 0.05);
}

TEST(noise_floor, is_unknown_below_six_pairs_and_says_so) {
  EXPECT_EQ(noise_floor({}, 7).to_text(), "noise floor unknown: no A/A pairs");
  EXPECT_EQ(noise_floor({0.01}, 7).to_text(), "noise floor unknown: 1 A/A pair, fewer than 6");
  EXPECT_EQ(noise_floor({1, 2, 3, 4, 5}, 7).to_text(), "noise floor unknown: 5 A/A pairs, fewer than 6");
  EXPECT_EQ(NoiseFloor({std::log(1.008), 7}).to_text(), "noise floor: 0.8 % (A/A of 7 pairs)");
}

/// Few pairs: what they tell must hold for the next ones.
TEST(noise_floor, comparisons_of_a_cell_with_itself_stay_below_it_95_times_of_100) {
  for (const int pairs : {7, 14}) {
    int below = 0;
    constexpr int trials = 600;
    Simulated simulated("normal");
    for (int trial = 0; trial < trials; ++trial) {
      const NoiseFloor floor = noise_floor(simulated.pairs(pairs), pairs);
      below += std::abs(trimmed_mean(simulated.pairs(pairs)).mean) <= *floor.log_ratio;
    }
    EXPECT_GE(below, trials * 0.925) << pairs;  // 95 % less three standard errors
  }
}

/// Seven rounds of a cell, its twin, which differs by 1 % this way or that, and another cell.
std::vector<Record> run_with_twins() {
  std::vector<Record> records;
  for (int round = 0; round < 7; ++round) {
    const double slow = 1 + 0.1 * round;
    records.push_back(make_record("omp_static", 2, round, slow));
    records.push_back(make_record("omp_static", 2, round, slow * (round % 2 ? 1.01 : 1 / 1.01)));
    records.back().twin = true;
    records.back().cell += "twin";
    records.push_back(make_record("omp_dynamic", 2, round, 3 * slow));
  }
  return records;
}

TEST(noise_floor, comes_from_the_twins_of_a_run) {
  auto records = run_with_twins();
  const auto ratios = twin_log_ratios(records);
  ASSERT_EQ(ratios.size(), 7u) << "drift and other cells do not count";
  for (const double ratio : ratios) EXPECT_NEAR(std::abs(ratio), std::log(1.01), 1e-12);
  const NoiseFloor floor = noise_floor(records);
  EXPECT_EQ(floor.pairs, 7);
  // Seven signs, the fifth at each end left out: at most a tenth of all draws agree in six or more.
  EXPECT_GT(*floor.log_ratio, std::log(1.01) / 2);
  EXPECT_LE(*floor.log_ratio, std::log(1.01) * 2.446912 / 1.959964 * (1 + 1e-6))
      << "Student's quantile for 7 pairs";
  records[1].valid = false;
  EXPECT_EQ(twin_log_ratios(records).size(), 6u) << "void launches do not count";
}

TEST(noise_floor, of_a_run_stands_in_the_caption_of_its_table) {
  const auto folder = std::filesystem::temp_directory_path() / ("raysweep_floor_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  nlohmann::json plan{{"experiment", "test"}, {"title", "title"}, {"interval", 0.02}};
  std::ofstream records(folder / "records.jsonl");
  for (const Record& r : run_with_twins()) {
    records << to_line(r) << "\n";
    if (r.round == 0) plan["cells"].push_back(to_json(r));
  }
  records.close();
  std::ofstream(folder / "plan.json") << plan;
  const RunData run = read_run(folder);
  std::filesystem::remove_all(folder);
  EXPECT_EQ(run.records.size(), 21u);
  EXPECT_EQ(run.rows.size(), 2u) << "a twin has no row";
  const std::string caption = scaling_table(run.rows, run.context).caption;
  EXPECT_NE(caption.find("\n" + run.context.floor.to_text() + "; against the best"), std::string::npos)
      << caption;
  EXPECT_EQ(run.context.floor.pairs, 7);
}

}  // namespace
}  // namespace raysweep
