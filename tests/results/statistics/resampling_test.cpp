#include "results/statistics/resampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "results/statistics/random.h"
#include "tests/results/statistics/simulated.h"

namespace raysweep {
namespace {

double pooled_median(const FramesByLaunch& frames) {
  std::vector<double> all;
  for (const auto& launch : frames) all.insert(all.end(), launch.begin(), launch.end());
  return median(std::move(all));
}

double mean_of_means(const FramesByLaunch& frames) {
  double sum = 0;
  for (const auto& launch : frames) {
    sum += std::accumulate(launch.begin(), launch.end(), 0.0) / static_cast<double>(launch.size());
  }
  return sum / static_cast<double>(frames.size());
}

/// Frames that share what their launch drew, and differ by half as much again.
FramesByLaunch simulate(Simulated& draw, Simulated& noise, int launches, int frames) {
  FramesByLaunch all(static_cast<size_t>(launches));
  for (auto& launch : all) {
    const double own = draw();
    for (int i = 0; i < frames; ++i) launch.push_back(own + 0.5 * noise());
  }
  return all;
}

double coverage(const std::string& kind, double truth, double (*statistic)(const FramesByLaunch&)) {
  constexpr int trials = 2000, launches = 7, frames = 2;
  Simulated draw(kind), noise("normal");
  for (int i = 0; i < 100; ++i) (void)noise();  // not the draws of the launches
  int covered = 0;
  for (int i = 0; i < trials; ++i) {
    const auto interval = hierarchical_bootstrap(simulate(draw, noise, launches, frames), statistic);
    covered += interval->low <= truth && truth <= interval->high;
  }
  return covered / double(trials);
}

double median_at(const std::vector<double>& samples, const std::vector<size_t>& places) {
  std::vector<double> drawn;
  for (const size_t place : places) drawn.push_back(samples[place]);
  return median(std::move(drawn));
}

TEST(bootstrap, of_places_draws_whole_samples_as_that_of_launches_with_one_frame_does) {
  const std::vector<double> samples{3, 1, 4, 1, 5, 9, 2, 6};
  FramesByLaunch launches;
  for (const double sample : samples) launches.push_back({sample});
  const auto statistic = [&](const std::vector<size_t>& places) {
    return std::optional(median_at(samples, places));
  };
  const auto by_places = bootstrap_places(samples.size(), samples.size(), statistic);
  const auto by_launches = hierarchical_bootstrap(launches, pooled_median);
  ASSERT_TRUE(by_places && by_launches);
  EXPECT_NEAR(by_places->low, by_launches->low, 0.5);
  EXPECT_NEAR(by_places->high, by_launches->high, 0.5);
  EXPECT_FALSE(bootstrap_places(samples.size(), 5, statistic)) << "one of its numbers has five samples only";
}

TEST(bootstrap, of_places_is_as_wide_as_the_fewest_samples_ask_for) {
  const auto mean_place = [](const std::vector<size_t>& places) {
    return std::optional(std::accumulate(places.begin(), places.end(), 0.0) /
                         static_cast<double>(places.size()));
  };
  const auto of_many = bootstrap_places(20, 20, mean_place), of_few = bootstrap_places(20, 6, mean_place);
  ASSERT_TRUE(of_many && of_few);
  EXPECT_LT(of_few->low, of_many->low);
  EXPECT_GT(of_few->high, of_many->high);
}

TEST(bootstrap, of_places_draws_again_where_there_is_no_number) {
  const auto often_none = [](const std::vector<size_t>& places) {
    return places[0] == 0 ? std::nullopt : std::optional(static_cast<double>(places[0]));
  };
  const auto interval = bootstrap_places(8, 8, often_none);
  ASSERT_TRUE(interval);
  EXPECT_GE(interval->low, 1);
  const auto always_none = [](const std::vector<size_t>&) { return std::optional<double>(); };
  EXPECT_FALSE(bootstrap_places(8, 8, always_none));
}

TEST(bootstrap, covers_the_truth_over_launches_that_differ) {
  const double of_mean = coverage("normal", 0, mean_of_means);
  RecordProperty("mean", std::to_string(of_mean));
  EXPECT_GE(of_mean, 0.93);
}

/// Of nine launches in ten with a standard deviation of σ = √(0.005² + 0.01²) and one that is far off, the
/// median is σ·Φ⁻¹(0.5/0.9) = 0.1397 σ from the middle of the nine, towards the one.
TEST(bootstrap, covers_the_median_of_two_modes) {
  const double of_median = coverage("bimodal", -0.1397 * std::hypot(0.005, 0.01), pooled_median);
  RecordProperty("median", std::to_string(of_median));
  EXPECT_GE(of_median, 0.93);
}

TEST(bootstrap, launches_that_are_alike_are_worth_no_more_than_their_number) {
  FramesByLaunch frames;  // each launch repeats its own number
  for (int launch = 0; launch < 7; ++launch) frames.emplace_back(100, double(launch));
  const auto interval = hierarchical_bootstrap(frames, mean_of_means);
  const double students = 2 * 2.447 * std::sqrt(28.0 / 6 / 7);  // Σ(x − 3)² = 28
  EXPECT_NEAR(interval->high - interval->low, students, 0.15 * students);
}

TEST(bootstrap, needs_six_launches) {
  const FramesByLaunch five(5, {1, 2, 3});
  EXPECT_FALSE(hierarchical_bootstrap(five, pooled_median));
  EXPECT_TRUE(hierarchical_bootstrap(FramesByLaunch(6, {1, 2, 3}), pooled_median));
}

TEST(bootstrap, is_the_same_each_time) {
  Simulated draw("normal"), noise("log-normal");
  const auto frames = simulate(draw, noise, 8, 5);
  const auto a = hierarchical_bootstrap(frames, pooled_median),
             b = hierarchical_bootstrap(frames, pooled_median);
  EXPECT_EQ(a->low, b->low);
  EXPECT_EQ(a->high, b->high);
  EXPECT_NE(a->low, hierarchical_bootstrap(frames, pooled_median, 2)->low) << "another seed";
}

/// The standard fixes the engine; its distributions differ from library to library, and are not used.
TEST(random_draws, are_the_highest_bits_of_the_standard_engine) {
  Random random(5);
  std::mt19937_64 engine(5);
  for (int i = 0; i < 1000; ++i) {
    uint64_t expected = engine() >> 61;
    while (expected == 7) expected = engine() >> 61;
    EXPECT_EQ(random.index(7), expected);
  }
  EXPECT_EQ(random.sign(), (engine() >> 63) != 0 ? 1 : -1);
  EXPECT_EQ(random.index(1), 0u);
}

TEST(random_draws, find_every_index_equally_often) {
  Random random(1);
  std::vector<int> counts(7);
  for (int i = 0; i < 70000; ++i) counts[random.index(7)]++;
  for (const int count : counts) EXPECT_NEAR(count, 10000, 4 * std::sqrt(10000 * 6.0 / 7));
}

}  // namespace
}  // namespace raysweep
