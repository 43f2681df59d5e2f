// The overhead laboratory's conclusions, from made-up measurements.
#include <gtest/gtest.h>

#include <cmath>

#include "experiments/errors.h"
#include "experiments/overhead/comparison.h"
#include "experiments/overhead/idle_burn.h"
#include "experiments/overhead/metg.h"
#include "experiments/overhead/numbers_text.h"
#include "experiments/overhead/row_samples.h"
#include "experiments/overhead/subject.h"
#include "experiments/overhead/tables.h"
#include "schedulers/registry.h"

namespace raysweep {
namespace {

using Kind = Metg::Kind;

TEST(metg, is_where_efficiency_crosses_the_bound_interpolated_in_the_logarithm_of_size) {
  // Halfway from 0.4 to 0.6, so halfway from 100 to 400 in factors.
  const auto metg = find_metg({{50, 0.2}, {100, 0.4}, {400, 0.6}, {800, 0.9}}, 0.5);
  ASSERT_TRUE(metg);
  EXPECT_EQ(metg->kind, Kind::bracketed);
  EXPECT_NEAR(metg->nanoseconds, 200, 1e-9);
  EXPECT_FALSE(metg->noisy);
}

TEST(metg, of_a_scheduler_with_a_fixed_cost_a_task_is_found) {
  // Efficiency t / (t + c): half at t = c, 95 % at t = 19 c.
  constexpr double cost = 130;
  std::vector<TaskSize> sizes;
  for (double t = 5; t < 1e5; t *= 2) sizes.push_back({t, t / (t + cost)});
  EXPECT_NEAR(find_metg(sizes, 0.5)->nanoseconds, cost, 0.02 * cost);
  EXPECT_NEAR(find_metg(sizes, 0.95)->nanoseconds, 19 * cost, 0.05 * 19 * cost);
}

TEST(metg, takes_sizes_in_any_order) {
  EXPECT_NEAR(find_metg({{400, 0.6}, {800, 0.9}, {100, 0.4}}, 0.5)->nanoseconds, 200, 1e-9);
}

TEST(metg, with_noise_counts_from_the_largest_size_below_the_bound) {
  const auto metg = find_metg({{100, 0.4}, {200, 0.7}, {400, 0.4}, {1600, 0.6}}, 0.5);
  ASSERT_TRUE(metg);
  EXPECT_EQ(metg->kind, Kind::bracketed);
  EXPECT_NEAR(metg->nanoseconds, 800, 1e-9);
  EXPECT_TRUE(metg->noisy);
}

TEST(metg, a_size_that_just_reaches_the_bound_counts_as_reaching) {
  EXPECT_DOUBLE_EQ(find_metg({{100, 0.4}, {200, 0.5}, {400, 0.8}}, 0.5)->nanoseconds, 200);
}

TEST(metg, never_reached_is_above_the_largest_size) {
  const auto metg = find_metg({{100, 0.1}, {200, 0.2}}, 0.5);
  EXPECT_EQ(metg->kind, Kind::above);
  EXPECT_EQ(metg_text(metg), "not bracketed (> 200.0 ns)");
}

TEST(metg, lost_again_at_the_largest_size_is_above_it) {
  const auto metg = find_metg({{100, 0.6}, {200, 0.4}}, 0.5);
  EXPECT_EQ(metg->kind, Kind::above);
  EXPECT_TRUE(metg->noisy);
}

TEST(metg, always_reached_is_at_most_the_smallest_size) {
  const auto metg = find_metg({{6.1, 0.97}, {12.2, 0.99}}, 0.95);
  EXPECT_EQ(metg->kind, Kind::at_most);
  EXPECT_EQ(metg_text(metg), "not bracketed (≤ 6.100 ns)");
}

TEST(metg, of_nothing_is_nothing) {
  EXPECT_FALSE(find_metg({}, 0.5));
  EXPECT_EQ(metg_text(std::nullopt), "–");
}

TEST(overhead, a_duration_has_the_unit_that_fits) {
  EXPECT_EQ(duration_text(12.34), "12.34 ns");
  EXPECT_EQ(duration_text(12340), "12.34 µs");
  EXPECT_EQ(duration_text(-1.234e7), "-12.34 ms");
  EXPECT_EQ(duration_text(2e9), "2.000 s");
}

TEST(overhead, a_chunk_costs_what_many_take_longer_than_none_on_all_processors) {
  RowSamples samples;
  samples.region_seconds = std::vector<double>(9, 10e-6);
  samples.chunks_seconds = std::vector<double>(9, 1010e-6);
  samples.chunks = 50'000;
  const auto cost = nanoseconds_per_chunk(samples, 2);
  ASSERT_TRUE(cost && cost->interval);
  EXPECT_NEAR(cost->value, 40, 1e-9);
  EXPECT_NEAR(cost->interval->low, 40, 1e-9);
  samples.chunks_seconds.clear();
  EXPECT_FALSE(nanoseconds_per_chunk(samples, 2));
}

TEST(overhead, samples_come_back_from_their_line) {
  RowSamples samples;
  samples.region_seconds = {1e-6, 1.0 / 3};
  samples.chunks = 12;
  samples.sizes = {{4, 1e-3}};
  samples.burns = {{0.004, true}, {1, false}};
  const RowSamples back = row_samples_from_line(to_line(samples));
  EXPECT_EQ(back.region_seconds, samples.region_seconds);
  EXPECT_EQ(back.chunks, 12);
  EXPECT_EQ(back.sizes.at(0).seconds, 1e-3);
  EXPECT_FALSE(back.burns.at(1).went_quiet);
}

/// A process on a clock of its own: other threads burn until `until`, of which the part from `off` to `on`
/// they are not let; each sleep of a millisecond costs itself 20 µs.
class FakeProcess {
 public:
  FakeProcess(double until, double off, double on) : until_(until), off_(off), on_(on) {}
  double cpu_seconds() const {
    const auto burnt = [this](double t) { return std::min(t, off_) + std::max(0.0, t - on_); };
    return 0.02 * now_ + burnt(std::min(now_, until_));
  }
  double sleep() {
    now_ += 1e-3;
    return 1e-3;
  }
  [[nodiscard]] IdleBurn watch() {
    return watch_idle([this] { return cpu_seconds(); }, [this] { return sleep(); });
  }

 private:
  double until_, off_, on_, now_ = 0;
};

TEST(idle_burn, is_the_processor_time_until_the_process_goes_quiet) {
  const IdleBurn burn = FakeProcess(0.004, 10, 10).watch();
  EXPECT_TRUE(burn.went_quiet);
  EXPECT_NEAR(burn.cpu_seconds, 0.004, 0.0002);
}

TEST(idle_burn, of_workers_who_sleep_at_once_is_nothing) {
  const IdleBurn burn = FakeProcess(0, 10, 10).watch();
  EXPECT_TRUE(burn.went_quiet);
  EXPECT_EQ(burn.cpu_seconds, 0);
}

TEST(idle_burn, goes_on_after_another_process_had_its_time_slice) {
  const IdleBurn burn = FakeProcess(0.03, 0.01, 0.02).watch();
  EXPECT_TRUE(burn.went_quiet);
  EXPECT_NEAR(burn.cpu_seconds, 0.02, 0.001);
}

TEST(idle_burn, of_workers_who_never_sleep_ends_at_the_cap) {
  const IdleBurn burn = FakeProcess(100, 100, 100).watch();
  EXPECT_FALSE(burn.went_quiet);
  EXPECT_NEAR(burn.cpu_seconds, idle_burn_cap_seconds, 0.05);
}

std::vector<Round> rounds(double direct, double ours, double spread) {
  std::vector<Round> list;
  for (int i = 0; i < 20; ++i) list.push_back({direct, ours + spread * (i - 9.5)});
  return list;
}

TEST(comparison, holds_within_ten_nanoseconds_or_two_percent) {
  EXPECT_EQ(judge(compare(rounds(30, 38, 0))), OverheadVerdict::holds);      // 27 %, but 8 ns
  EXPECT_EQ(judge(compare(rounds(5000, 5050, 0))), OverheadVerdict::holds);  // 50 ns, but 1 %
  EXPECT_EQ(judge(compare(rounds(300, 100, 0))), OverheadVerdict::holds);    // cheaper
  EXPECT_EQ(judge(compare(rounds(300, 330, 0.1))), OverheadVerdict::does_not_hold);
}

TEST(comparison, is_undecided_where_the_interval_contains_the_claim) {
  EXPECT_EQ(judge(compare(rounds(100, 110, 1))), OverheadVerdict::undecided);
  EXPECT_EQ(judge(compare({{100, 200}, {100, 200}})), OverheadVerdict::undecided)
      << "two rounds give no interval";
}

TEST(comparison, what_disturbs_both_ways_of_a_round_cancels) {
  std::vector<Round> list;
  for (int i = 0; i < 20; ++i) list.push_back({100.0 + 50 * i, 105.0 + 50 * i});
  const Comparison result = compare(list);
  EXPECT_DOUBLE_EQ(result.difference.value, 5);
  EXPECT_DOUBLE_EQ(result.difference.interval->low, result.difference.interval->high);
}

TEST(comparison, both_ways_are_first_equally_often) {
  std::string order;
  const auto taken = take_turns(
      [&] {
        order += 'd';
        return 1.0;
      },
      [&] {
        order += 'o';
        return 2.0;
      },
      4);
  EXPECT_EQ(order,
            "oddoodd"
            "ood");
  ASSERT_EQ(taken.size(), 4u);
  EXPECT_EQ(taken[3].direct, 1);
  EXPECT_EQ(taken[3].ours, 2);
}

template <class Call>
std::string refusal(Call call) {
  try {
    call();
  } catch (const RequestError& error) {
    return error.what();
  }
  return "not refused";
}

TEST(overhead_options, counts_of_threads_are_numbers_and_what_the_machine_has) {
  EXPECT_EQ(parse_threads("1,cores,processors", 4, 8), (std::vector{1, 4, 8}));
  EXPECT_EQ(parse_threads("3,1,cores", 1, 2), (std::vector{1, 3}));
}

TEST(overhead_options, other_counts_of_threads_are_refused) {
  for (const char* list : {"0", "1025", "two", "", "1,,2", "-1", "2x"}) {
    EXPECT_NE(refusal([&] { (void)parse_threads(list, 2, 2); }).find("is no count of threads; possible: "),
              std::string::npos)
        << list;
  }
}

TEST(overhead_options, an_unknown_scheduler_is_refused_with_those_that_there_are) {
  const std::vector<std::string> names{"tbbb"};
  const std::vector threads{1};
  EXPECT_TRUE(refusal([&] {
                (void)scheduler_subjects(names, threads, WaitPolicy::usual);
              }).starts_with("--scheduler: unknown scheduler \"tbbb\"; possible: serial, thread_static, "));
}

TEST(overhead_options, an_unknown_wait_policy_is_refused) {
  EXPECT_EQ(refusal([] { (void)parse_wait_policy("busy"); }),
            "--wait-policy: \"busy\" is none; possible: default, active, passive");
  EXPECT_EQ(parse_wait_policy("passive"), WaitPolicy::passive);
}

TEST(overhead_options, what_a_scheduler_cannot_vary_is_measured_once) {
  const std::vector<std::string> names{"serial", "thread_dynamic"};
  const std::vector threads{2, 4};
  const auto subjects = scheduler_subjects(names, threads, WaitPolicy::passive);
  ASSERT_EQ(subjects.size(), 3u);
  EXPECT_EQ(subjects[0].text(), "serial, 1 thread");
  EXPECT_EQ(subjects[1].text(), "thread_dynamic, 2 threads, passive");
  EXPECT_EQ(subjects[2].threads, 4);
}

TEST(overhead_options, ways_to_wait_are_measured_quiet_and_beside_load_where_somebody_waits) {
  const std::vector threads{1, 2};
  const auto quiet = waiting_subjects(threads, false), both = waiting_subjects(threads, true);
  EXPECT_EQ(both.size(), 2 * quiet.size());
  EXPECT_TRUE(std::all_of(both.begin(), both.end(), [](const Subject& s) { return s.threads == 2; }));
  ASSERT_GE(quiet.size(), 4u);
  EXPECT_EQ(quiet[1].text(), "thread_static, 2 threads, active");
  EXPECT_EQ(quiet[3].text(), "thread_static, 2 threads, spin 10000");
  EXPECT_EQ(both[7].text(), "thread_static, 2 threads, spin 10000, beside a busy process");
}

TEST(overhead_options, every_available_scheduler_is_measured_by_default) {
  const std::vector threads{1};
  const auto subjects = scheduler_subjects({}, threads, WaitPolicy::usual);
  for (const SchedulerInfo& info : all_schedulers()) {
    const bool there = std::any_of(subjects.begin(), subjects.end(),
                                   [&](const Subject& s) { return s.scheduler == info.name; });
    EXPECT_EQ(there, why_unavailable(info).empty()) << info.name;
  }
}

TEST(overhead_tables, rows_are_as_long_as_their_heads_and_name_what_went_wrong) {
  OverheadRow row{{"thread_dynamic", {}, 4}};
  row.problem = "killed by signal 9";
  const std::vector rows{row};
  for (const Table& table : {scheduler_table(rows, 2), waiting_table(rows, 2), scheduler_numbers(rows, 2),
                             waiting_numbers(rows, 2)}) {
    EXPECT_EQ(table.rows.at(0).size(), table.columns.size());
    EXPECT_EQ(table.rows.at(0).back(), "killed by signal 9; oversubscribed");
  }
}

}  // namespace
}  // namespace raysweep
