// Kernels other than intersection: that all their ways compute the same, and what is told of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

#include "experiments/kernel_bench.h"
#include "experiments/kernel_run.h"
#include "experiments/kernel_timer.h"
#include "experiments/kernels/expression_templates.h"
#include "experiments/kernels/small_kernel.h"

namespace raysweep {
namespace {

KernelPlan plan_of(const std::string& sweep, const std::string& measure = "") {
  return make_plan(parse_kernel_config(
      "experiment = \"x\"\nkind = \"kernel\"\n[sweep]\n" + sweep + "[measure]\n" + measure, "a.toml", {}, 2));
}

const std::string everything =
    "kernel = [\"expression_templates\", \"virtual_calls\", \"branches\", \"dot_products\"]\n"
    "iterations = [1, 100]\nlength = [1, 10, 5000]\nhit_rate = [0, 0.3, 1]\n";

TEST(small_kernels, all_ways_of_a_kernel_compute_the_same_bit_for_bit) {
  const KernelPlan plan = plan_of(everything);
  EXPECT_GE(plan.cells.size(), 6u * 2 + 5 * 3 * 2 + 2 * 3 + 2) << "those of x86 may be missing";
  for (const KernelCell& cell : plan.cells) {
    for (const uint64_t seed : {1U, 2U}) {
      const auto pass = cell.small->prepare(cell.values, seed);
      EXPECT_EQ(pass->why_wrong(), "") << cell.key;
      EXPECT_EQ(pass->run(), pass->run()) << cell.key;
    }
  }
}

TEST(small_kernels, a_result_that_differs_by_one_bit_is_wrong) {
  const auto operands = random_operands(1);
  std::vector<FourFloats> results;
  results.reserve(operands.size());
  for (const Operands& each : operands) results.push_back(expected_of(each));
  EXPECT_EQ(why_results_wrong(operands, results), "");
  results[63][2] = std::bit_cast<float>(std::bit_cast<uint32_t>(results[63][2]) ^ 1U);
  EXPECT_EQ(why_results_wrong(operands, results).find("evaluation 63 is "), 0u);
}

TEST(small_kernels, expressions_are_what_they_say) {
  Operands operands{};
  operands[0] = {1, 2, 3, 4};
  operands[1] = {10, 20, 30, 40};
  operands[2] = {2, 2, 2, 0};
  operands[3] = {5, 5, 5, 5};
  operands[4] = {1, 2, 3, 4};
  EXPECT_EQ(expected_of(operands), (FourFloats{17, 34, 51, -20})) << "(a + b) · c − d · e";
}

TEST(small_kernels, of_evaluations_timed_one_by_one_the_mean_lies_between_the_least_and_the_most) {
  const KernelPlan plan = plan_of("kernel = \"expression_templates\"\niterations = 1000\n");
  for (const KernelCell& cell : plan.cells) {
    const auto ticks = cell.small->prepare(cell.values, 1)->ticks();
    ASSERT_TRUE(ticks) << cell.key;
    EXPECT_LE(ticks->min, ticks->avg) << cell.key;
    EXPECT_LE(ticks->avg, ticks->max) << cell.key;
    EXPECT_GT(ticks->sum, 0) << cell.key;
    EXPECT_DOUBLE_EQ(ticks->sum, ticks->avg * 1000) << cell.key;
  }
}

TEST(small_kernels, only_first_passes_are_disturbed) {
  for (const KernelCell& cell : plan_of(everything).cells) {
    const auto pass = cell.small->prepare(cell.values, 1);
    const bool is_first = cell.values.contains("pass") && cell.values.at("pass") == "first";
    EXPECT_EQ(pass->is_disturbed(), is_first) << cell.key;
    if (is_first) {
      EXPECT_EQ(std::to_string(pass->operations()), cell.values.at("length"));
    }
    pass->disturb();
    EXPECT_EQ(pass->why_wrong(), "") << cell.key;
  }
}

TEST(small_kernels, that_take_long_are_estimated_to) {
  const auto seconds = [](const std::string& sweep) {
    return estimate_seconds(plan_of(sweep, "rounds = 1\nsamples = 1\nmin_time = 0.001\n"));
  };
  EXPECT_LT(seconds("kernel = \"expression_templates\"\niterations = 10\n"), 0.1);
  EXPECT_GT(seconds("kernel = \"expression_templates\"\niterations = 10000000\n"), 1);
}

TEST(small_kernels, leave_a_record_that_tells_what_they_were) {
  if (const std::string reason = why_no_kernel_timer(); !reason.empty()) GTEST_SKIP() << reason;
  const KernelPlan plan = plan_of(everything, "samples = 2\nmin_time = 0.0001\n");
  KernelBench bench(plan);
  for (const KernelCell& cell : plan.cells) {
    const KernelRecord record = bench.measure(cell, 3, 0);
    EXPECT_TRUE(record.valid) << record.reason;
    EXPECT_EQ(record.cell, cell.key);
    EXPECT_EQ(record.round, 3);
    EXPECT_EQ(record.kernel, cell.small->name);
    EXPECT_EQ(record.factors, cell.values);
    EXPECT_EQ(record.seconds.size(), 2u);
    for (const double seconds : record.seconds) EXPECT_GT(seconds, 0) << cell.key;
    EXPECT_EQ(record.ticks.has_value(), record.kernel == "expression_templates");
    EXPECT_EQ(bench.measure(cell, 4, 10).iterations, 10u) << "as many passes as are given";
  }
}

}  // namespace
}  // namespace raysweep
