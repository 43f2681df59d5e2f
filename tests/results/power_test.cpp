#include "results/power.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/results/make_record.h"

namespace raysweep {
namespace {

/// Rounds of a cell, two twins and two planted slowdowns, whose frames vary by `noise`.
std::vector<Record> study(int rounds, double noise, int twins = 2) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0, noise);
  std::vector<Record> records;
  const auto add = [&](int round, int twin, double slowdown) {
    Record r = make_record("thread_dynamic", 2, round, 0.1 * (1 + slowdown) * std::exp(normal(random)));
    r.twin = twin;
    r.slowdown = slowdown;
    r.cell += std::to_string(twin) + "/" + std::to_string(slowdown);
    r.launch_seconds = 0.5;
    records.push_back(r);
  };
  for (int round = 0; round < rounds; ++round) {
    for (int twin = 0; twin <= twins; ++twin) add(round, twin, 0);
    add(round, 0, 0.05);
    add(round, 0, 0.3);
  }
  return records;
}

TEST(power, blocks_of_more_and_more_launches_as_long_as_there_are_twenty) {
  const auto power = detection_power(study(300, 0.02));
  ASSERT_EQ(power.size(), 2u) << "21 blocks of 14, 10 of 28";
  EXPECT_EQ(power[0].launches, 7);
  EXPECT_EQ(power[1].launches, 14);
  for (const Detection& d : power[0].detections) EXPECT_EQ(d.comparisons, 42);
  EXPECT_DOUBLE_EQ(power[0].measuring_seconds, 3 * 7 * 0.5);
}

TEST(power, what_is_far_above_the_noise_is_found_and_what_is_not_there_hardly_ever) {
  const auto power = detection_power(study(700, 0.03));
  for (const Power& p : power) {
    ASSERT_EQ(p.detections.size(), 3u);
    EXPECT_EQ(p.detections[0].planted, 0);
    EXPECT_LE(p.detections[0].share(), 0.085);
    EXPECT_GT(p.detections[2].share(), 0.98) << "a slowdown of 30 %";
  }
  EXPECT_GT(power.back().detections[1].share(), power.front().detections[1].share())
      << "more launches find smaller differences";
  EXPECT_LT(power.back().noise_floor, power.front().noise_floor);
}

TEST(power, slower_is_not_faster) {
  auto records = study(140, 0.001);
  for (Record& r : records) {
    if (r.slowdown > 0) r.frame_seconds = {{0.05}};
  }
  const auto power = detection_power(records);
  for (const Detection& d : power.front().detections) {
    if (d.planted > 0) {
      EXPECT_EQ(d.found, 0);
    }
  }
}

TEST(power, is_known_only_where_twins_and_slowdowns_are) {
  EXPECT_TRUE(detection_power(study(200, 0.02, 1)).empty());
  EXPECT_TRUE(detection_power(study(100, 0.02)).empty()) << "14 comparisons of 7 launches";
  auto records = study(200, 0.02);
  std::erase_if(records, [](const Record& r) { return r.slowdown > 0; });
  EXPECT_TRUE(detection_power(records).empty());
}

TEST(power, the_table_says_what_is_found_reliably) {
  const std::vector<Power> power{
      {7, 0.013, 10.5, {{0, 200, 6}, {0.01, 200, 20}, {0.05, 200, 150}, {0.1, 200, 190}}},
      {14, 0.009, 21, {{0, 100, 3}, {0.01, 100, 20}, {0.05, 100, 80}, {0.1, 100, 100}}},
      {28, 0.009, 42, {{0, 50, 3}, {0.01, 50, 50}, {0.05, 50, 50}, {0.1, 50, 39}}}};
  const Table table = power_table(power);
  EXPECT_NE(table.caption.find(
                "80 times of 100: 10 % with 7 launches (10.5 s); 5 % with 14 launches (21 s); none of "
                "these with 28 launches"),
            std::string::npos)
      << table.caption;
  EXPECT_EQ(table.rows[0],
            (std::vector<std::string>{"7", "3.0 % (6 of 200)", "10.0 % (20 of 200)", "75.0 % (150 of 200)",
                                      "95.0 % (190 of 200)", "1.3 %", "10.5 s"}));
  EXPECT_EQ(power_data(power).rows.size(), 12u);
}

}  // namespace
}  // namespace raysweep
