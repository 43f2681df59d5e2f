#include "results/frame_times.h"

#include <gtest/gtest.h>

#include <cmath>

#include "results/tables/frame_tables.h"
#include "tests/results/make_record.h"
#include "tests/results/statistics/simulated.h"

namespace raysweep {
namespace {

/// NumPy 1.24: numpy.quantile([3, 1, 4, 1, 5, 9, 2, 6, 5, 3], [.05, .5, .95], method='linear'); R's default
/// is the same.
TEST(quantile, is_definition_7_of_hyndman_and_fan) {
  const std::vector<double> samples{3, 1, 4, 1, 5, 9, 2, 6, 5, 3};
  EXPECT_NEAR(quantile(samples, 0.05), 1.0, 1e-12);
  EXPECT_NEAR(quantile(samples, 0.5), 3.5, 1e-12);
  EXPECT_NEAR(quantile(samples, 0.95), 7.65, 1e-12);
  EXPECT_EQ(quantile(samples, 1), 9);
  EXPECT_EQ(quantile({2}, 0.95), 2);
}

FramesByLaunch seven_launches(int frames) {
  Simulated draw("normal");
  FramesByLaunch all;
  for (int i = 0; i < 7; ++i) {
    all.push_back(draw.list(frames));
    for (double& f : all.back()) f = 0.1 * std::exp(f);
  }
  return all;
}

TEST(frame_times, are_of_all_frames_of_all_launches) {
  const auto times = frame_times({{1, 2, 3}, {4, 5}, {6, 7, 8, 9, 10, 11}}, {20, 30, 10});
  EXPECT_EQ(times->launches, 3);
  EXPECT_EQ(times->frames, 11);
  EXPECT_EQ(times->p50.value, 6);
  EXPECT_EQ(times->p5, 1.5);
  EXPECT_EQ(times->p95.value, 10.5);
  EXPECT_EQ(times->max, 11);
  EXPECT_EQ(times->cold, 20);
  EXPECT_FALSE(times->p50.interval) << "three launches";
  EXPECT_FALSE(frame_times({}, {}));
}

TEST(frame_times, have_a_99th_percentile_from_a_hundred_on) {
  EXPECT_FALSE(frame_times(seven_launches(14), {})->p99);
  EXPECT_TRUE(frame_times(seven_launches(15), {})->p99);
}

/// Counting ranks is a short cut for what the bootstrap of the frames themselves gives.
TEST(frame_times, intervals_are_the_bootstraps) {
  const auto frames = seven_launches(30);
  const auto quantile_of = [](double share) {
    return [share](const FramesByLaunch& drawn) {
      std::vector<double> all;
      for (const auto& launch : drawn) all.insert(all.end(), launch.begin(), launch.end());
      return quantile(std::move(all), share);
    };
  };
  const auto times = frame_times(frames, {});
  const auto p50 = hierarchical_bootstrap(frames, quantile_of(0.5));
  const auto p95 = hierarchical_bootstrap(frames, quantile_of(0.95));
  EXPECT_NEAR(times->p50.interval->low, p50->low, 1e-12);
  EXPECT_NEAR(times->p50.interval->high, p50->high, 1e-12);
  EXPECT_NEAR(times->p95.interval->low, p95->low, 1e-12);
  EXPECT_NEAR(times->p95.interval->high, p95->high, 1e-12);
}

TEST(frame_times, effective_frames_count_what_a_launch_repeats_but_once) {
  FramesByLaunch repeating;
  for (int i = 0; i < 8; ++i) repeating.emplace_back(20, 0.1 + 0.01 * i);
  EXPECT_NEAR(effective_frames(repeating), 8, 1e-9);
  EXPECT_GT(effective_frames(seven_launches(200)), 700) << "independent ones";
  EXPECT_EQ(effective_frames(seven_launches(1)), 7) << "nothing is known of what launches repeat";
  // Two launches of two frames: squares between 4·1, within 4·0.25, so that ρ = (4 − 0.5)/(4 + 0.5).
  EXPECT_NEAR(effective_frames({{0.5, 1.5}, {2.5, 3.5}}), 4 / (1 + 3.5 / 4.5), 1e-12);
}

TEST(frame_times, a_high_quantile_has_an_interval_only_where_frames_reach_beyond_it) {
  EXPECT_FALSE(frame_times(seven_launches(3), {})->p95.interval);
  EXPECT_TRUE(frame_times(seven_launches(3), {})->p50.interval);
  EXPECT_TRUE(frame_times(seven_launches(40), {})->p95.interval);
}

/// Launches differ by 15 % of what frames do. The median is 0, and the 95 % quantile √(1 + 0.15²)·1.6449.
TEST(frame_times, intervals_cover_what_they_are_of) {
  Simulated own("normal"), noise("normal");
  for (int i = 0; i < 99; ++i) (void)noise();
  const double p95 = 10 + std::hypot(1, 0.15) * 1.6449;
  int trials = 0, of_p50 = 0, of_p95 = 0, with_p95 = 0;
  for (; trials < 300; ++trials) {
    FramesByLaunch frames(7);
    for (auto& launch : frames) {
      const double middle = 10 + 0.15 * own() / 0.02;
      for (int i = 0; i < 24; ++i) launch.push_back(middle + noise() / 0.02);
    }
    const auto times = frame_times(frames, {});
    of_p50 += times->p50.interval->low <= 10 && 10 <= times->p50.interval->high;
    if (!times->p95.interval) continue;
    with_p95++;
    of_p95 += times->p95.interval->low <= p95 && p95 <= times->p95.interval->high;
  }
  RecordProperty("p50", std::to_string(of_p50 / double(trials)));
  RecordProperty("p95", std::to_string(of_p95 / double(with_p95)));
  EXPECT_GE(of_p50, 0.93 * trials);
  EXPECT_GE(of_p95, 0.93 * with_p95);
  EXPECT_GT(with_p95, trials / 2);
}

TEST(frame_tables, hold_milliseconds_for_people_and_seconds_for_programs) {
  std::vector<Record> records, planned;
  for (int round = 0; round < 7; ++round) {
    records.push_back(make_record("serial", 1, round, 0.1));
    records.back().frame_seconds = {{0.1, 0.1, 0.2}};
    records.back().warmup_seconds = {0.5, 0.2};
    if (round == 0) planned = {records[0], make_record("omp_static", 2, 0, 0)};
  }
  const auto rows = summarise(records, planned, 0.5);
  const auto times = frame_times(rows);
  const Table table = frame_table(rows, times);
  EXPECT_EQ(table.rows[0],
            (std::vector<std::string>{"serial", "1", "7", "21", "100.0", "100.0 [100.0, 200.0]", "200.0", "–",
                                      "200.0", "500.0"}));
  EXPECT_EQ(table.rows[1][2], "–") << "not launched";
  const Table data = frame_data(rows, times);
  EXPECT_EQ(data.rows[0].back(), "0.5");
  EXPECT_EQ(data.rows[0].size(), data.columns.size());
  EXPECT_EQ(data.rows[1].size(), data.columns.size());
}

}  // namespace
}  // namespace raysweep
