// What is timed has been compared first.
#include "experiments/kernel_bench.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "experiments/intersection/protocols.h"
#include "experiments/kernel_timer.h"
#include "experiments/scheduled_pass.h"
#include "schedulers/registry.h"

namespace raysweep {
namespace {

TEST(kernel_bench, hits_must_be_those_that_are_clear_and_no_more_than_unclear_ones_beside) {
  const KnownHits known{100, 5};
  EXPECT_EQ(why_wrong(100, 100, known), "");
  EXPECT_EQ(why_wrong(105, 100, known), "");
  EXPECT_EQ(why_wrong(106, 105, known), "106 hits, where 100 are certain and 5 tests are unclear");
  EXPECT_EQ(why_wrong(99, 100, known), "99 hits, where 100 are certain and 5 tests are unclear");
  EXPECT_EQ(why_wrong(105, 99, known), "105 hits, where the base kernel has 99 and 5 tests are unclear");
  EXPECT_EQ(why_wrong(100, 101, {100, 0}), "100 hits, where the base kernel has 101 and 0 tests are unclear");
}

KernelPlan tiny_plan(const std::string& sweep) {
  return make_plan(parse_kernel_config(
      "experiment = \"x\"\nkind = \"kernel\"\n[sweep]\nmethod = \"wald\"\nprecision = \"float\"\n" + sweep +
          "[measure]\nsamples = 4\nmin_time = 0.0001\n",
      "a.toml", {}, 2));
}

class KernelBenchTimes : public testing::Test {
 public:
  void SetUp() override {
    if (const std::string reason = why_no_kernel_timer(); !reason.empty()) GTEST_SKIP() << reason;
  }
};

TEST_F(KernelBenchTimes, a_cell_and_tells_what_it_was) {
  const KernelPlan plan = tiny_plan("protocol = \"hit-rate\"\nhit_rate = 0.3\n");
  KernelBench bench(plan);
  const KernelRecord first = bench.measure(plan.cells.at(0), 2, 0);
  EXPECT_TRUE(first.valid) << first.reason;
  EXPECT_EQ(first.cell, "wald/base/float/hit-rate/0.3");
  EXPECT_EQ(first.round, 2);
  EXPECT_EQ(first.change, "base");
  EXPECT_EQ(first.variant.division, "early");
  EXPECT_EQ(first.variant.data, "precomputed");
  EXPECT_EQ(first.protocol, "hit-rate");
  EXPECT_EQ(first.parameter, 0.3);
  EXPECT_DOUBLE_EQ(first.hit_rate, 0.3);
  EXPECT_EQ(first.tests, 1024u * 80);
  EXPECT_EQ(first.seconds.size(), 4u);
  EXPECT_GT(first.iterations, 0u);
  for (const double seconds : first.seconds) EXPECT_GT(seconds, 0);
  EXPECT_EQ(bench.measure(plan.cells.at(0), 3, 7).iterations, 7u) << "as many passes as are given";
}

TEST_F(KernelBenchTimes, threads_share_the_tests_of_a_pass) {
  const KernelPlan plan = tiny_plan("protocol = \"random\"\nthreads = [1, 2, 3]\n");
  KernelBench bench(plan);
  for (const KernelCell& cell : plan.cells) {
    const KernelRecord record = bench.measure(cell, 0, 5);
    EXPECT_TRUE(record.valid) << record.reason;
    EXPECT_EQ(record.tests, 131'072u);
    EXPECT_EQ(record.iterations, 5u);
    EXPECT_EQ(record.hit_rate, bench.measure(plan.cells.at(0), 0, 5).hit_rate);
    EXPECT_EQ(record.seconds.size(), 4u);
  }
}

TEST_F(KernelBenchTimes, a_scheduler_shares_the_tests_of_a_pass) {
  const KernelPlan plan =
      tiny_plan("protocol = \"clusters\"\nthreads = [1, 3]\nscheduler = [\"shares\", \"thread_dynamic\"]\n");
  KernelBench bench(plan);
  for (const KernelCell& cell : plan.cells) {
    const KernelRecord record = bench.measure(cell, 0, 5);
    EXPECT_TRUE(record.valid) << record.cell << ": " << record.reason;
    EXPECT_EQ(record.scheduler, cell.scheduler);
    EXPECT_EQ(record.threads, cell.threads);
    EXPECT_EQ(record.clock, "wall") << "the same one for all cells: " << record.cell;
    EXPECT_EQ(record.seconds.size(), 4u);
  }
}

TEST_F(KernelBenchTimes, one_thread_is_timed_by_the_processors_clock_where_no_cell_has_more) {
  const KernelPlan plan = tiny_plan("protocol = \"random\"\n");
  EXPECT_EQ(KernelBench(plan).measure(plan.cells.at(0), 0, 5).clock, "processor");
}

TEST(scheduled_pass, runs_each_part_once_and_tells_their_sum) {
  for (const std::string_view scheduler : kernel_schedulers()) {
    if (!why_unavailable(*find_scheduler(scheduler)).empty()) continue;
    std::vector<int> runs(10);
    std::vector<TimedPass> parts;
    for (int i = 0; i < 10; ++i) {
      parts.emplace_back([&runs, i] {
        ++runs[i];
        return static_cast<double>(i);
      });
    }
    ScheduledPass pass(std::string(scheduler), 3, parts);
    EXPECT_EQ(pass.run(), 45) << scheduler;
    EXPECT_EQ(pass.run(), 45) << scheduler;
    EXPECT_EQ(runs, std::vector<int>(10, 2)) << scheduler;
  }
}

TEST(scheduled_pass, is_never_on_openmp_whose_threads_spin_on) {
  for (const std::string_view scheduler : kernel_schedulers())
    EXPECT_FALSE(scheduler.starts_with("omp")) << scheduler;
}

// Without any upper limit: what sleeps takes at least so long.
TEST_F(KernelBenchTimes, threads_are_timed_until_the_last_has_ended) {
  const auto sleep = [](int milliseconds) {
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    return 1.0;
  };
  const Timing timing =
      time_passes({[] { return 1.0; }, [&] { return sleep(10); }, [] { return 1.0; }}, {"x", 3, 0, 2});
  ASSERT_EQ(timing.seconds.size(), 3u);
  for (const double seconds : timing.seconds) EXPECT_GE(seconds, 0.02) << "two passes of 10 ms";
}

}  // namespace
}  // namespace raysweep
