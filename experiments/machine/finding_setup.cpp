// Checks of how the machine is set up.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/machine/finding_checks.h"

namespace raysweep {

Finding check_quota(const Examination& e) {
  const char* const name = "quota";
  const Fact<double>& quota = e.facts.quota;
  const Fact<int>& allowed = e.facts.allowed_processors;
  if (!quota.value) return unknown(name, quota.reason);
  if (std::isinf(*quota.value)) return good(name, "unlimited");
  if (!allowed.value) return unknown(name, allowed.reason);
  const std::string value = fmt::format("{:g} of {} processors", *quota.value, *allowed.value);
  if (*quota.value >= *allowed.value) return good(name, value);
  return bad(
      name, value, "more threads than that are stopped in the middle of frames",
      fmt::format("use at most {:g} threads, or lift the quota: `echo max | sudo tee "
                  "/sys/fs/cgroup/GROUP/cpu.max` (GROUP is in /proc/self/cgroup), or start the container "
                  "without a limit of processors (docker: without --cpus)",
                  std::max(1.0, std::floor(*quota.value))));
}

Finding check_allowed(const Examination& e) {
  const char* const name = "allowed processors";
  const Fact<int>&allowed = e.facts.allowed_processors, &online = e.facts.online_processors;
  if (!allowed.value) return unknown(name, allowed.reason);
  if (!online.value) return unknown(name, online.reason);
  const std::string value = fmt::format("{} of {} online", *allowed.value, *online.value);
  if (*allowed.value >= *online.value) return good(name, value);
  return bad(
      name, value,
      "the others' work shares caches, memory and turbo with ours, and results hold for a part of the "
      "machine",
      fmt::format("fine if you meant it; else start from a shell that may use all: `taskset -c {}`, and look "
                  "for a cpuset in /proc/self/cgroup",
                  e.facts.online_list.value.value_or("0-…")));
}

Finding check_smt(const Examination& e) {
  const char* const name = "SMT";
  const Fact<std::string>& smt = e.facts.smt;
  if (!smt.value) return unknown(name, smt.reason);
  if (*smt.value != "on") return good(name, *smt.value);
  if (!e.facts.siblings_allowed.value.value_or(true))
    return good(name, "on, but one thread a core is allowed");
  return bad(
      name, "on",
      "two threads on one core slow each other down, and which are so placed changes from launch to launch",
      "pin the threads (`--pin cores`), or switch it off: `echo off | sudo tee "
      "/sys/devices/system/cpu/smt/control`; leave it on to study hyper-threading itself");
}

Finding check_turbo(const Examination& e) {
  const char* const name = "turbo";
  const Fact<bool>& turbo = e.facts.turbo;
  if (!turbo.value) return unknown(name, turbo.reason);
  if (!*turbo.value) return good(name, "off");
  const bool intel = e.facts.scaling_driver.value.value_or("").starts_with("intel_");
  return bad(name, "on", "one thread runs faster than each of many: the base of every speedup is inflated",
             intel ? "`echo 1 | sudo tee /sys/devices/system/cpu/intel_pstate/no_turbo`"
                   : "`echo 0 | sudo tee /sys/devices/system/cpu/cpufreq/boost`");
}

Finding check_governor(const Examination& e) {
  const char* const name = "governor";
  const Fact<std::string>& governor = e.facts.governor;
  if (!governor.value) return unknown(name, governor.reason);
  if (*governor.value == "performance") return good(name, *governor.value);
  return bad(name, *governor.value,
             "the frequency follows the load, late: short launches run slower than long ones",
             "`sudo cpupower frequency-set -g performance`");
}

Finding check_virtual_machine(const Examination& e) {
  const char* const name = "virtual machine";
  const Fact<std::string>& machine = e.facts.virtual_machine;
  if (!machine.value) return unknown(name, machine.reason);
  const std::string container = e.facts.container.value.value_or("no");
  const std::string inside = container == "no" ? "" : fmt::format(", in a container ({})", container);
  if (*machine.value == "no") return good(name, "no" + inside);
  return bad(
      name, *machine.value + inside,
      "others share the processors unseen, and cores, caches and hyper-threads may not be what they seem",
      "measure on a machine of your own (in a cloud: an instance type \"metal\"), or trust only what is "
      "compared within one run, beside its co-run ceiling");
}

Finding check_clock(const Examination& e) {
  constexpr double coarse = 1e-6;
  // Others are read by a system call, or from a slow device.
  constexpr std::array quick{"tsc", "kvm-clock", "hyperv_clocksource_tsc_page", "arch_sys_counter"};
  const char* const name = "clock";
  const TimerReport& timer = e.timer;
  if (timer.source.empty()) return unknown(name, "the timer was not calibrated");
  const Fact<std::string>& kernel = e.facts.clock_source;
  const std::string value = fmt::format("{} to {:.0f} ns, {:.0f} ns of overhead taken off{}", timer.source,
                                        timer.resolution_seconds * 1e9, timer.overhead_seconds * 1e9,
                                        kernel.value ? ", kernel: " + *kernel.value : "");
  const bool slow = kernel.value && std::find(quick.begin(), quick.end(), *kernel.value) == quick.end();
  if (!slow && timer.resolution_seconds < coarse) return good(name, value);
  return bad(
      name, value, "reading the clock costs microseconds: it shows in short frames and in every item",
      "`cat /sys/devices/system/clocksource/clocksource0/available_clocksource`; if tsc is among them: "
      "`echo tsc | sudo tee /sys/devices/system/clocksource/clocksource0/current_clocksource`");
}

Finding check_huge_pages(const Examination& e) {
  const char* const name = "huge pages";
  const Fact<std::string>& pages = e.facts.huge_pages;
  if (!pages.value) return unknown(name, pages.reason);
  if (*pages.value != "always") return good(name, *pages.value);
  return bad(name, *pages.value,
             "whether a launch gets them depends on how fragmented memory is: large scenes differ from "
             "launch to launch",
             "`echo madvise | sudo tee /sys/kernel/mm/transparent_hugepage/enabled`");
}

Finding check_layout(const Examination& e) {
  // Where code and stack lie changes times by more than many an optimisation (Mytkowicz et al. 2009,
  // "Producing wrong data without doing anything obviously wrong!"); drawn anew for each launch it becomes
  // noise that intervals cover (Curtsinger & Berger 2013, "Stabilizer").
  const char* const name = "address layout";
  const Fact<bool>& random = e.facts.layout_random;
  if (!random.value) return unknown(name, random.reason);
  if (*random.value) return good(name, "random");
  return bad(name, "fixed", "all launches share one layout of memory, lucky or not, and no interval shows it",
             "`echo 2 | sudo tee /proc/sys/kernel/randomize_va_space`, and start without `setarch -R`");
}

Finding check_build(const Examination& e) {
  const char* const name = "build";
  const BuildFacts& build = e.build;
  if (build.type.empty()) return unknown(name, "the build has no type");
  const char* const advice =
      "`cmake --preset release && cmake --build --preset release`, then build/release/raysweep";
  if (!build.sanitizers.empty()) {
    return bad(name, fmt::format("{}, sanitizers {}", build.type, build.sanitizers),
               "sanitizers slow down some code more than other code: nothing can be compared", advice);
  }
  if (build.type == "Release") return good(name, build.type);
  return bad(name, build.type, "without full optimisation other code is slow than in what people run",
             advice);
}

}  // namespace raysweep
