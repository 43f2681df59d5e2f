// What lies between two readings: by made-up numbers, and by files that the test writes.
#include "experiments/machine/machine_state.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "experiments/machine/machine_watch.h"
#include "tests/experiments/machine/fake_root.h"

namespace raysweep {
namespace {

/// Two readings two seconds apart, on four processors.
struct Readings {
  StateCounters before, after;
  Readings() {
    before.processors = after.processors = 4;
    before.wall_seconds = 100;
    after.wall_seconds = 102;
  }
  [[nodiscard]] LaunchState change() const { return change_between(before, after); }
};

TEST(state_change, others_used_what_is_busy_less_what_we_used) {
  Readings r;
  r.before.busy_seconds = 50;
  r.after.busy_seconds = 57;
  r.before.own_seconds = 3;
  r.after.own_seconds = 9;
  EXPECT_EQ(r.change().wall_seconds, 2);
  EXPECT_EQ(r.change().other_processors, 0.5);
  r.after.own_seconds = 12;
  EXPECT_EQ(r.change().other_processors, 0) << "our time is exact, that of processors counted in ticks";
}

TEST(state_change, shares_are_of_wall_time) {
  Readings r;
  r.before.steal_seconds = 1;
  r.after.steal_seconds = 3;
  r.before.pressure_seconds = 0.25;
  r.after.pressure_seconds = 0.75;
  EXPECT_EQ(r.change().steal_share, 0.25) << "of 2 s on 4 processors";
  EXPECT_EQ(r.change().pressure_share, 0.25) << "of 2 s";
}

TEST(state_change, counters_are_subtracted) {
  Readings r;
  r.before.throttled_seconds = r.before.thermal_throttles = r.before.major_faults = 1;
  r.before.voluntary_switches = r.before.involuntary_switches = 10;
  r.after.throttled_seconds = 1.5;
  r.after.thermal_throttles = 4;
  r.after.major_faults = 1;
  r.after.voluntary_switches = 30;
  r.after.involuntary_switches = 11;
  const LaunchState change = r.change();
  EXPECT_EQ(change.throttled_seconds, 0.5);
  EXPECT_EQ(change.thermal_throttles, 3);
  EXPECT_EQ(change.major_faults, 0);
  EXPECT_EQ(change.voluntary_switches, 20);
  EXPECT_EQ(change.involuntary_switches, 1);
}

TEST(state_change, what_either_reading_does_not_know_is_unknown) {
  Readings r;
  r.after.busy_seconds = r.after.steal_seconds = r.after.pressure_seconds = r.after.throttled_seconds = 1;
  const auto json = state_as_json(r.change());
  for (const auto& [name, value] : json.items()) EXPECT_EQ(value.is_null(), name != "wall_seconds") << name;
}

TEST(state_change, a_window_of_few_ticks_does_not_tell_who_used_processors) {
  Readings r;
  r.before.busy_seconds = r.before.steal_seconds = r.before.pressure_seconds = 0;
  r.after.busy_seconds = r.after.steal_seconds = r.after.pressure_seconds = 0.01;
  r.after.wall_seconds = 100.09;
  EXPECT_FALSE(r.change().other_processors);
  EXPECT_FALSE(r.change().steal_share);
  EXPECT_TRUE(r.change().pressure_share) << "counted in microseconds";
  r.after.wall_seconds = 100.11;
  EXPECT_TRUE(r.change().other_processors);
  EXPECT_TRUE(r.change().steal_share);
}

TEST(state_change, readings_of_different_processors_do_not_tell_who_used_them) {
  Readings r;
  r.before.busy_seconds = r.after.busy_seconds = 1;
  r.before.processors = 1;
  EXPECT_FALSE(r.change().other_processors);
}

TEST(state, is_read_from_the_lines_of_the_allowed_processors) {
  const FakeRoot root;
  // user nice system idle iowait irq softirq steal guest
  root.write("proc/stat",
             "cpu  99999 9 9 9 9 9 9 9 9 9\n"
             "cpu0 100 20 3 5000 700 40 5 60 80 0\n"
             "cpu1 9999 9999 9999 9999 9999 9999 9999 9999 0 0\n"
             "cpu10 1000 0 0 0 0 0 0 200 0 0\n"
             "intr 123\n");
  const StateCounters state = read_state(root.path(), {0, 10});
  const double tick = 1.0 / static_cast<double>(sysconf(_SC_CLK_TCK));
  EXPECT_EQ(state.processors, 2);
  EXPECT_NEAR(*state.busy_seconds, (168 + 1000) * tick, 1e-9);
  EXPECT_NEAR(*state.steal_seconds, 260 * tick, 1e-9);
}

TEST(state, pressure_throttling_and_heat_come_from_their_files) {
  const FakeRoot root;
  root.write("proc/pressure/cpu",
             "some avg10=1.00 avg60=2.00 avg300=3.00 total=1500000\nfull avg10=0.00 avg60=0.00 avg300=0.00 "
             "total=7\n");
  root.write("proc/self/cgroup", "0::/a\n");
  root.write("sys/fs/cgroup/a/cpu.stat", "throttled_usec 250000\n");
  root.write("sys/devices/system/cpu/cpu0/thermal_throttle/core_throttle_count", "2\n");
  const StateCounters state = read_state(root.path(), {0});
  EXPECT_DOUBLE_EQ(*state.pressure_seconds, 1.5);
  EXPECT_DOUBLE_EQ(*state.throttled_seconds, 0.25);
  EXPECT_EQ(state.thermal_throttles, 2);
}

TEST(state, without_files_only_what_the_process_knows_of_itself_is_known) {
  const FakeRoot root;
  const StateCounters state = read_state(root.path());
  for (const auto& v : {state.busy_seconds, state.steal_seconds, state.pressure_seconds,
                        state.throttled_seconds, state.thermal_throttles})
    EXPECT_FALSE(v);
  EXPECT_GT(state.own_seconds, 0);
  EXPECT_TRUE(state.voluntary_switches && state.involuntary_switches && state.major_faults);
}

TEST(state, own_time_grows_with_own_work) {
  const FakeRoot root;
  const StateCounters before = read_state(root.path());
  StateCounters after = before;
  for (int i = 0; i < 1000 && after.own_seconds < before.own_seconds + 0.02; ++i) {
    EXPECT_GT(spin_seconds(), 0);
    after = read_state(root.path());
  }
  EXPECT_GE(after.own_seconds - before.own_seconds, 0.02) << "in 1000 spins of about 1 ms";
  EXPECT_GT(after.wall_seconds, before.wall_seconds);
}

TEST(processes, are_read_whatever_their_name) {
  const FakeRoot root;
  root.write("proc/12/stat", "12 (a (b) c) S 1 12 12 0 -1 4194304 1 0 0 0 150 50 0 0 20 0 1 0 8 1 1\n");
  root.write("proc/13/stat", "13 no name\n");
  root.write("proc/self/stat", "12 (a) S 1 12 12 0 -1 4194304 1 0 0 0 150 50 0 0 20 0 1 0 8 1 1\n");
  const auto times = process_times(root.path());
  ASSERT_EQ(times.size(), 1u);
  EXPECT_EQ(times.at(12).name, "a (b) c");
  EXPECT_DOUBLE_EQ(times.at(12).seconds, 200.0 / static_cast<double>(sysconf(_SC_CLK_TCK)));
  EXPECT_TRUE(process_times(root.path() / "nowhere").empty());
}

TEST(processes, the_busiest_come_first_without_ourselves_and_the_idle) {
  const std::map<int, ProcessTime> before{{1, {"idle", 10}}, {2, {"old", 4}}, {3, {"we", 0}}};
  const std::map<int, ProcessTime> after{
      {1, {"idle", 10.01}}, {2, {"old", 5}}, {3, {"we", 2}}, {4, {"new", 1.5}}};
  const auto busy = busiest_between(before, after, 2, 3);
  ASSERT_EQ(busy.size(), 2u);
  EXPECT_EQ(busy[0].name, "new");
  EXPECT_EQ(busy[0].processors, 0.75);
  EXPECT_EQ(busy[1].id, 2);
  EXPECT_EQ(busy[1].processors, 0.5);
  std::map<int, ProcessTime> many;
  for (int id = 10; id < 30; ++id) many[id] = {"x", 1.0 * id};
  EXPECT_EQ(busiest_between({}, many, 1, 0).size(), 5u);
  EXPECT_EQ(busiest_between({}, many, 1, 0)[0].id, 29);
}

TEST(watch, reads_everything_at_least_once) {
  const FakeRoot root;
  const MachineWatch watch = watch_machine(0.1, root.path());
  EXPECT_GE(watch.change.wall_seconds.value_or(0), 0.1);
  EXPECT_GE(watch.spin_seconds.size(), 1u);
  EXPECT_TRUE(watch.busiest.empty());
}

}  // namespace
}  // namespace raysweep
