// Facts from a /proc and /sys that the test writes.
#include "experiments/machine/machine_facts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "experiments/machine/build_facts.h"
#include "experiments/machine/control_groups.h"
#include "experiments/machine/machine.h"
#include "tests/experiments/machine/fake_root.h"

namespace raysweep {
namespace {

const std::string cpu = "sys/devices/system/cpu/";

class Facts : public testing::Test {
 public:
  FakeRoot root;
  OwnProcessors own{{0, 1}, false};

  [[nodiscard]] MachineFacts read() const { return read_machine_facts(own, root.path()); }
};

TEST_F(Facts, a_missing_file_is_unknown_with_its_name_and_no_warning) {
  testing::internal::CaptureStderr();
  const auto json = to_json(read());
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  int unknown = 0;
  for (const auto& [name, fact] : json.items()) {
    if (fact["state"] == "unknown") unknown++;
    EXPECT_EQ(fact["state"] == "unknown", fact["reason"] != "") << name;
    EXPECT_NE(fact["reason"], "not read") << name;
  }
  // All but what the process knows of itself.
  EXPECT_EQ(unknown, static_cast<int>(json.size()) - 3) << json.dump(1);
  EXPECT_EQ(json["allowed_list"]["state"], "0-1");
  EXPECT_EQ(json["clock_source"]["reason"],
            "/sys/devices/system/clocksource/clocksource0/current_clocksource cannot be read");
}

TEST_F(Facts, smt_is_on_off_or_not_there) {
  EXPECT_FALSE(read().smt.value);
  own.siblings_allowed = true;
  EXPECT_EQ(read().smt.value, "on") << "hwloc sees it though no file tells";
  own.siblings_allowed = false;
  root.write(cpu + "smt/active", "1\n");
  EXPECT_EQ(read().smt.value, "on");
  root.write(cpu + "smt/active", "0\n");
  EXPECT_EQ(read().smt.value, "not there");
  root.write(cpu + "smt/control", "notsupported\n");
  EXPECT_EQ(read().smt.value, "not there");
  root.write(cpu + "smt/control", "off\n");
  EXPECT_EQ(read().smt.value, "off");
}

TEST_F(Facts, turbo_is_what_either_driver_says) {
  root.write(cpu + "cpufreq/boost", "1\n");
  EXPECT_EQ(read().turbo.value, true);
  root.write(cpu + "intel_pstate/no_turbo", "1\n");
  EXPECT_EQ(read().turbo.value, false) << "intel_pstate's word counts";
  root.write(cpu + "intel_pstate/no_turbo", "0\n");
  EXPECT_EQ(read().turbo.value, true);
}

TEST_F(Facts, frequencies_are_of_the_allowed_processors) {
  for (const char* processor : {"cpu0", "cpu1", "cpu2"}) {
    const std::string folder = cpu + processor + "/cpufreq/";
    const bool allowed = std::string(processor) != "cpu2";
    root.write(folder + "scaling_governor", allowed ? "performance\n" : "powersave\n");
    root.write(folder + "scaling_driver", "intel_pstate\n");
    root.write(folder + "scaling_min_freq", !allowed                           ? "100\n"
                                            : processor == std::string("cpu0") ? "800000\n"
                                                                               : "900000\n");
    root.write(folder + "scaling_max_freq", !allowed                           ? "5000000\n"
                                            : processor == std::string("cpu0") ? "3600000\n"
                                                                               : "3000000\n");
  }
  MachineFacts facts = read();
  EXPECT_EQ(facts.governor.value, "performance");
  EXPECT_EQ(facts.scaling_driver.value, "intel_pstate");
  EXPECT_EQ(facts.min_frequency.value, 8e8);
  EXPECT_EQ(facts.max_frequency.value, 3.6e9);
  own.allowed = {1, 2};
  EXPECT_EQ(read().governor.value, "performance, powersave");
}

TEST_F(Facts, processors_are_counted_from_lists) {
  root.write(cpu + "online", "0-3,8\n");
  root.write(cpu + "isolated", "\n");
  root.write(cpu + "nohz_full", "2-3\n");
  const MachineFacts facts = read();
  EXPECT_EQ(facts.online_processors.value, 5);
  EXPECT_EQ(facts.allowed_processors.value, 2);
  EXPECT_EQ(facts.isolated.value, "none");
  EXPECT_EQ(facts.nohz_full.value, "2-3");
}

TEST_F(Facts, a_hypervisor_shows_in_the_flags_or_else_in_the_tables_of_the_firmware) {
  root.write("proc/cpuinfo", "processor : 0\nflags\t\t: fpu tsc constant_tsc nonstop_tsc\n");
  root.write("sys/class/dmi/id/product_name", "m5.metal\n");
  root.write("sys/class/dmi/id/sys_vendor", "Amazon EC2\n");
  EXPECT_EQ(read().virtual_machine.value, "no") << "bare metal of a cloud";
  EXPECT_EQ(read().invariant_tsc.value, true);
  root.write("proc/cpuinfo", "flags\t\t: fpu tsc constant_tsc hypervisor\n");
  EXPECT_EQ(read().virtual_machine.value, "Amazon EC2");
  EXPECT_EQ(read().invariant_tsc.value, false);
  root.write("sys/class/dmi/id/sys_vendor", "?\n");
  EXPECT_EQ(read().virtual_machine.value, "yes (hypervisor flag of the processor)");
  root.write("proc/cpuinfo", "Features\t: fp asimd\n");
  EXPECT_EQ(read().virtual_machine.value, "no") << "the tables are there and name none";
  root.write("sys/class/dmi/id/product_name", "KVM Virtual Machine\n");
  EXPECT_EQ(read().virtual_machine.value, "KVM");
}

TEST_F(Facts, a_container_shows_in_its_files_its_environment_or_its_groups) {
  EXPECT_FALSE(read().container.value) << "nothing hints at one, but nothing could";
  root.write("proc/1/environ", std::string("A=1\0B=2\0", 8));
  EXPECT_EQ(read().container.value, "no");
  root.write("proc/1/cgroup", "0::/kubepods/pod1\n");
  EXPECT_EQ(read().container.value, "kubepods");
  root.write("proc/1/environ", std::string("A=1\0container=lxc\0", 18));
  EXPECT_EQ(read().container.value, "lxc");
  root.write(".dockerenv", "");
  EXPECT_EQ(read().container.value, "docker");
}

TEST_F(Facts, the_least_quota_on_the_way_up_counts) {
  root.write("proc/self/cgroup", "0::/user/job\n");
  const std::string mount = "sys/fs/cgroup/";
  EXPECT_FALSE(read().quota.value) << "no control groups";
  root.write(mount + "cgroup.controllers", "cpu\n");
  EXPECT_TRUE(std::isinf(*read().quota.value)) << "groups, but none with a quota";
  EXPECT_EQ(to_json(read())["quota"]["state"], "unlimited");
  root.write(mount + "user/job/cpu.max", "max 100000\n");
  EXPECT_TRUE(std::isinf(*read().quota.value));
  root.write(mount + "user/cpu.max", "150000 100000\n");
  EXPECT_EQ(read().quota.value, 1.5);
  root.write(mount + "user/job/cpu.max", "400000 100000\n");
  EXPECT_EQ(read().quota.value, 1.5);
}

TEST_F(Facts, a_quota_of_version_1_counts_too) {
  root.write("proc/self/cgroup", "4:memory:/a\n3:cpu,cpuacct:/a\n0::/\n");
  const std::string group = "sys/fs/cgroup/cpu,cpuacct/a/";
  root.write(group + "cpu.cfs_period_us", "100000\n");
  root.write(group + "cpu.cfs_quota_us", "-1\n");
  EXPECT_TRUE(std::isinf(*read().quota.value));
  root.write(group + "cpu.cfs_quota_us", "50000\n");
  EXPECT_EQ(read().quota.value, 0.5);
}

TEST_F(Facts, throttling_is_summed_over_groups_and_versions) {
  root.write("proc/self/cgroup", "3:cpu:/a\n0::/b\n");
  root.write("sys/fs/cgroup/unified/b/cpu.stat", "usage_usec 5\nthrottled_usec 2000000\n");
  EXPECT_EQ(read().throttled_seconds.value, 2);
  root.write("sys/fs/cgroup/cpu/a/cpu.stat", "nr_throttled 1\nthrottled_time 500000000\n");
  EXPECT_EQ(read().throttled_seconds.value, 2.5);
}

TEST_F(Facts, memory_and_swap_are_bytes) {
  root.write(
      "proc/meminfo",
      "MemTotalElse: 7 kB\nMemTotal:  1000 kB\nMemAvailable: 600 kB\nSwapTotal: 50 kB\nSwapFree: 20 kB\n");
  const MachineFacts facts = read();
  EXPECT_EQ(facts.memory_bytes.value, 1000 * 1024);
  EXPECT_EQ(facts.free_memory_bytes.value, 600 * 1024);
  EXPECT_EQ(facts.swap_used_bytes.value, 30 * 1024);
}

TEST_F(Facts, settings_of_memory_clock_and_kernel) {
  root.write("sys/kernel/mm/transparent_hugepage/enabled", "always [madvise] never\n");
  root.write("sys/devices/system/clocksource/clocksource0/current_clocksource", "tsc\n");
  root.write("proc/sys/kernel/osrelease", "6.1.0\n");
  root.write("proc/loadavg", "0.50 0.40 0.30 1/100 1234\n");
  root.write("proc/sys/kernel/randomize_va_space", "2\n");
  root.write(cpu + "cpu0/thermal_throttle/core_throttle_count", "3\n");
  root.write(cpu + "cpu1/thermal_throttle/core_throttle_count", "4\n");
  MachineFacts facts = read();
  EXPECT_EQ(facts.huge_pages.value, "madvise");
  EXPECT_EQ(facts.clock_source.value, "tsc");
  EXPECT_EQ(facts.kernel.value, "6.1.0");
  EXPECT_EQ(facts.load_average.value, 0.5);
  EXPECT_EQ(facts.thermal_throttles.value, 7);
  EXPECT_EQ(facts.layout_random.value, true);
  root.write("proc/self/personality", "00040000\n");
  EXPECT_EQ(read().layout_random.value, false) << "setarch -R";
  root.write("proc/self/personality", "00000000\n");
  root.write("proc/sys/kernel/randomize_va_space", "0\n");
  EXPECT_EQ(read().layout_random.value, false);
}

TEST(build, says_what_was_built_and_from_what) {
  const auto json = to_json(build_facts());
  EXPECT_EQ(json["type"], RAYSWEEP_BUILD_TYPE);
  EXPECT_NE(json["flags"].get<std::string>().find("-ffp-contract=off"), std::string::npos) << json["flags"];
  const std::string commit = json["commit"];
  EXPECT_TRUE(commit == "unknown" || commit.find_first_not_of("0123456789abcdef") == std::string::npos);
  EXPECT_EQ(commit == "unknown", !build_facts().commit.value);
}

TEST(machine, is_written_with_facts_timer_and_build_beside_what_was_there) {
  const auto json = to_json(detect_machine());
  for (const char* key : {"host", "cpu", "kernel", "compiler", "packages", "cores", "pus", "load", "topology",
                          "quota", "smt", "facts", "timer", "build"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_EQ(json["facts"]["allowed_processors"]["state"], json["pus"]);
  EXPECT_GT(json["timer"]["ticks_per_second"], 0);
}

}  // namespace
}  // namespace raysweep
