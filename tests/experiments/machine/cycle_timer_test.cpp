// The timer on clocks that the test turns by hand, and what little can be claimed of the real one.
#include "experiments/machine/cycle_timer.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace raysweep {
namespace {

using Mode = CycleTimer::Mode;

// Readings cost time on this clock: 100 ns for one of nanoseconds, `cost` ticks for one of ticks, of which 3
// make a nanosecond.
struct FakeClock {
  uint64_t ticks = 0, cost = 0;
};
FakeClock fake;

uint64_t fake_ticks() { return fake.ticks += fake.cost; }
uint64_t fake_nanoseconds() { return (fake.ticks += 300) / 3; }
constexpr TickSource fake_source{fake_ticks, fake_ticks};

/// Begin, so many ticks, end.
void time_ticks(CycleTimer& timer, uint64_t ticks) {
  timer.begin();
  fake.ticks += ticks;
  timer.end();
}

TEST(cycle_timer, has_sum_least_most_and_mean_of_what_lies_between_begin_and_end) {
  fake = {1000, 0};
  CycleTimer timer(fake_source, 0);
  for (const Mode mode : {Mode::sum, Mode::min, Mode::max, Mode::avg}) EXPECT_EQ(timer.ticks(mode), 0);
  for (const uint64_t ticks : {30, 10, 80}) {
    time_ticks(timer, ticks);
    fake.ticks += 1'000'000;  // outside: not timed
  }
  EXPECT_EQ(timer.count(), 3u);
  EXPECT_EQ(timer.ticks(Mode::sum), 120);
  EXPECT_EQ(timer.ticks(Mode::min), 10);
  EXPECT_EQ(timer.ticks(Mode::max), 80);
  EXPECT_EQ(timer.ticks(Mode::avg), 40);
}

TEST(cycle_timer, takes_its_overhead_off_and_never_goes_below_zero) {
  fake = {0, 7};
  const uint64_t overhead = measure_overhead(fake_source);
  EXPECT_EQ(overhead, 7u);
  CycleTimer timer(fake_source, overhead);
  time_ticks(timer, 100);
  EXPECT_EQ(timer.ticks(Mode::sum), 100);
  CycleTimer too_much(fake_source, 50);
  time_ticks(too_much, 20);
  EXPECT_EQ(too_much.ticks(Mode::sum), 0);
  EXPECT_EQ(too_much.count(), 1u);
}

TEST(cycle_timer, a_counter_that_went_back_counts_as_nothing) {
  fake = {1000, 0};
  CycleTimer timer(fake_source, 0);
  timer.begin();
  fake.ticks = 900;
  timer.end();
  EXPECT_EQ(timer.ticks(Mode::max), 0);
}

TEST(calibration, finds_the_rate_of_ticks_against_nanoseconds) {
  fake = {uint64_t{1} << 60, 9};  // decades of ticks: a double alone would lose them
  const TickRate rate = measure_rate(fake_source, fake_nanoseconds);
  EXPECT_NEAR(rate.ticks_per_second, 3e9, 3e9 * 1e-6);
  EXPECT_LT(rate.error, 1e-6);
}

// A clock whose ticks slow down as time goes on.
uint64_t drifting_ticks() {
  return fake.ticks + fake.ticks * (100'000'000 - fake.ticks % 100'000'000) / 100'000'000;
}

TEST(calibration, a_rate_that_changes_has_an_error) {
  fake = {1000, 0};
  EXPECT_GT(measure_rate({drifting_ticks, drifting_ticks}, fake_nanoseconds).error, 1e-2);
}

// Every third reading a tick further.
uint64_t coarse_ticks() { return fake.ticks++ / 3 * 50; }

TEST(resolution, is_the_least_difference_other_than_zero) {
  fake = {0, 0};
  EXPECT_EQ(measure_resolution({coarse_ticks, coarse_ticks}), 50u);
  EXPECT_EQ(measure_resolution(fake_source), 0u) << "of a clock that stands still";
}

TEST(tsc, is_a_clock_only_where_it_is_invariant_and_can_be_read_in_order) {
  EXPECT_EQ(why_no_tsc({true, true, true}), "");
  EXPECT_NE(why_no_tsc({true, true, false}).find("not invariant"), std::string::npos);
  EXPECT_NE(why_no_tsc({true, false, true}).find("rdtscp"), std::string::npos);
  EXPECT_NE(why_no_tsc({false, false, false}).find("not x86"), std::string::npos);
}

TEST(timer_report, tells_cost_and_resolution_in_seconds) {
  TickClock clock;
  clock.name = "steady_clock";
  clock.why = "the processor is not x86";
  clock.ticks_per_second = 2e9;
  clock.calibration_error = 0.25;
  clock.overhead_ticks = 40;
  clock.resolution_ticks = 2;
  const auto json = to_json(timer_report(clock));
  EXPECT_EQ(json["source"], "steady_clock");
  EXPECT_EQ(json["why"], "the processor is not x86");
  EXPECT_DOUBLE_EQ(json["overhead_seconds"], 20e-9);
  EXPECT_DOUBLE_EQ(json["resolution_seconds"], 1e-9);
  EXPECT_EQ(json["calibration_error"], 0.25);
  clock.ticks_per_second = 0;
  EXPECT_EQ(clock.seconds(5), 0) << "a clock without a rate";
}

TEST(this_clock, runs_forward_and_says_why_where_it_is_not_the_counter) {
  const TickClock& clock = tick_clock();
  EXPECT_GT(clock.ticks_per_second, 0);
  EXPECT_EQ(clock.name == "tsc", clock.why.empty());
  uint64_t before = clock.source.begin();
  for (int i = 0; i < 1000; ++i) {
    const uint64_t now = clock.source.end();
    EXPECT_GE(now, before);
    before = now;
  }
  CycleTimer timer;
  timer.begin();
  timer.end();
  EXPECT_EQ(timer.count(), 1u);
}

}  // namespace
}  // namespace raysweep
