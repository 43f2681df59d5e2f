// Every check: what it calls good, what bad and what unknown.
#include "experiments/machine/findings.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

namespace raysweep {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A machine without faults, of which everything is known.
Examination quiet_machine() {
  Examination e;
  MachineFacts& f = e.facts;
  f.smt = std::string("off");
  f.siblings_allowed = f.turbo = false;
  f.governor = std::string("performance");
  f.scaling_driver = std::string("intel_pstate");
  f.allowed_processors = f.online_processors = 8;
  f.online_list = std::string("0-7");
  f.virtual_machine = f.container = std::string("no");
  f.quota = infinity;
  f.load_average = 0.1;
  f.clock_source = std::string("tsc");
  f.memory_bytes = 1e10;
  f.free_memory_bytes = 8e9;
  f.swap_used_bytes = 0.0;
  f.huge_pages = std::string("madvise");
  f.layout_random = true;
  e.build.type = "Release";
  e.timer.source = "tsc";
  e.timer.resolution_seconds = 1e-8;
  LaunchState& c = e.watch.change;
  c.wall_seconds = 2;
  c.other_processors = c.steal_share = c.pressure_share = c.throttled_seconds = c.thermal_throttles = 0;
  e.watch.spin_seconds.assign(40, 2e-4);
  e.noise = {0.01, 20};
  return e;
}

using Change = std::function<void(Examination&)>;

/// A change to a quiet machine, and what the check of that name then says.
struct Case {
  std::string name;
  FindingState state;
  std::string contains;  // in value, why or advice
  Change change;
};

constexpr FindingState is_bad = FindingState::bad, is_good = FindingState::good,
                       is_unknown = FindingState::unknown;
template <class T>
Fact<T> not_known() {
  return Fact<T>::unknown("no such file");
}

const std::vector<Case> cases{
    {"noise (A/A test)", is_good, "1.0 % between 7 launches and 7", [](Examination&) {}},
    {"noise (A/A test)", is_bad, "raise measure.launches", [](Examination& e) { e.noise.log_ratio = 0.03; }},
    {"noise (A/A test)", is_unknown, "it was killed",
     [](Examination& e) {
       e.noise.log_ratio.reset();
       e.noise_unknown = "it was killed";
     }},
    {"quota", is_bad, "at most 1 threads", [](Examination& e) { e.facts.quota = 1.5; }},
    {"quota", is_bad, "7.5 of 8 processors", [](Examination& e) { e.facts.quota = 7.5; }},
    {"quota", is_good, "8 of 8", [](Examination& e) { e.facts.quota = 8.0; }},
    {"quota", is_good, "unlimited", [](Examination& e) { e.facts.allowed_processors = not_known<int>(); }},
    {"quota", is_unknown, "no such file", [](Examination& e) { e.facts.quota = not_known<double>(); }},
    {"throttling", is_bad, "0.500 s", [](Examination& e) { e.watch.change.throttled_seconds = 0.5; }},
    {"throttling", is_bad, "3 times by heat", [](Examination& e) { e.watch.change.thermal_throttles = 3; }},
    {"throttling", is_good, "none", [](Examination& e) { e.watch.change.thermal_throttles = {}; }},
    {"throttling", is_unknown, "count",
     [](Examination& e) { e.watch.change.thermal_throttles = e.watch.change.throttled_seconds = {}; }},
    {"allowed processors", is_bad, "taskset -c 0-7", [](Examination& e) { e.facts.allowed_processors = 2; }},
    {"allowed processors", is_good, "8 of 8", [](Examination&) {}},
    {"allowed processors", is_unknown, "no such file",
     [](Examination& e) { e.facts.online_processors = not_known<int>(); }},
    {"SMT", is_bad, "--pin cores",
     [](Examination& e) {
       e.facts.smt = std::string("on");
       e.facts.siblings_allowed = true;
     }},
    {"SMT", is_good, "one thread a core", [](Examination& e) { e.facts.smt = std::string("on"); }},
    {"SMT", is_good, "off", [](Examination&) {}},
    {"SMT", is_unknown, "no such file", [](Examination& e) { e.facts.smt = not_known<std::string>(); }},
    {"turbo", is_bad, "echo 1 | sudo tee /sys/devices/system/cpu/intel_pstate/no_turbo",
     [](Examination& e) { e.facts.turbo = true; }},
    {"turbo", is_bad, "echo 0 | sudo tee /sys/devices/system/cpu/cpufreq/boost",
     [](Examination& e) {
       e.facts.turbo = true;
       e.facts.scaling_driver = std::string("acpi-cpufreq");
     }},
    {"turbo", is_good, "off", [](Examination&) {}},
    {"turbo", is_unknown, "no such file", [](Examination& e) { e.facts.turbo = not_known<bool>(); }},
    {"governor", is_bad, "sudo cpupower frequency-set -g performance",
     [](Examination& e) { e.facts.governor = std::string("performance, powersave"); }},
    {"governor", is_good, "performance", [](Examination&) {}},
    {"governor", is_unknown, "no such file",
     [](Examination& e) { e.facts.governor = not_known<std::string>(); }},
    {"virtual machine", is_bad, "KVM, in a container (docker)",
     [](Examination& e) {
       e.facts.virtual_machine = std::string("KVM");
       e.facts.container = std::string("docker");
     }},
    {"virtual machine", is_good, "no, in a container (lxc)",
     [](Examination& e) { e.facts.container = std::string("lxc"); }},
    {"virtual machine", is_unknown, "no such file",
     [](Examination& e) { e.facts.virtual_machine = not_known<std::string>(); }},
    {"clock", is_bad, "current_clocksource",
     [](Examination& e) { e.facts.clock_source = std::string("hpet"); }},
    {"clock", is_bad, "microseconds", [](Examination& e) { e.timer.resolution_seconds = 2e-6; }},
    {"clock", is_good, "tsc to 10 ns",
     [](Examination& e) { e.facts.clock_source = not_known<std::string>(); }},
    {"clock", is_good, "kernel: kvm-clock",
     [](Examination& e) { e.facts.clock_source = std::string("kvm-clock"); }},
    {"clock", is_unknown, "calibrated", [](Examination& e) { e.timer.source.clear(); }},
    {"huge pages", is_bad, "echo madvise",
     [](Examination& e) { e.facts.huge_pages = std::string("always"); }},
    {"huge pages", is_good, "never", [](Examination& e) { e.facts.huge_pages = std::string("never"); }},
    {"huge pages", is_unknown, "no such file",
     [](Examination& e) { e.facts.huge_pages = not_known<std::string>(); }},
    {"address layout", is_bad, "randomize_va_space", [](Examination& e) { e.facts.layout_random = false; }},
    {"address layout", is_good, "random", [](Examination&) {}},
    {"address layout", is_unknown, "no such file",
     [](Examination& e) { e.facts.layout_random = not_known<bool>(); }},
    {"build", is_bad, "--preset release", [](Examination& e) { e.build.type = "Debug"; }},
    {"build", is_bad, "sanitizers thread", [](Examination& e) { e.build.sanitizers = "thread"; }},
    {"build", is_good, "Release", [](Examination&) {}},
    {"build", is_unknown, "no type", [](Examination& e) { e.build.type.clear(); }},
    {"steal", is_bad, "3.0 %", [](Examination& e) { e.watch.change.steal_share = 0.03; }},
    {"steal", is_good, "0.5 %", [](Examination& e) { e.watch.change.steal_share = 0.005; }},
    {"steal", is_unknown, "too short", [](Examination& e) { e.watch.change.steal_share = {}; }},
    {"pressure", is_bad, "20.0 %", [](Examination& e) { e.watch.change.pressure_share = 0.2; }},
    {"pressure", is_good, "1.0 %", [](Examination& e) { e.watch.change.pressure_share = 0.01; }},
    {"pressure", is_unknown, "psi=1", [](Examination& e) { e.watch.change.pressure_share = {}; }},
    {"other load", is_bad, "cc1plus (812) 0.95",
     [](Examination& e) {
       e.watch.change.other_processors = 1;
       e.watch.busiest = {{812, "cc1plus", 0.95}};
     }},
    {"other load", is_bad, "no single process",
     [](Examination& e) { e.watch.change.other_processors = 0.17; }},
    {"other load", is_good, "0.15 of 8", [](Examination& e) { e.watch.change.other_processors = 0.15; }},
    {"other load", is_unknown, "too short", [](Examination& e) { e.watch.change.other_processors = {}; }},
    {"load average", is_bad, "1.50", [](Examination& e) { e.facts.load_average = 1.5; }},
    {"load average", is_good, "0.10", [](Examination&) {}},
    {"load average", is_unknown, "no such file",
     [](Examination& e) { e.facts.load_average = not_known<double>(); }},
    {"frequency", is_bad, "drifts by 50.0 %",
     [](Examination& e) { std::fill_n(e.watch.spin_seconds.begin(), 10, 3e-4); }},
    {"frequency", is_good, "drifts by 0.0 %", [](Examination& e) { e.watch.spin_seconds[7] = 1; }},
    {"frequency", is_bad, "drifts by 10.0 %",
     [](Examination& e) {
       e.watch.spin_seconds = {1.1e-4, 1e-4};
     }},
    {"frequency", is_unknown, "too short", [](Examination& e) { e.watch.spin_seconds.resize(1); }},
    {"frequency", is_unknown, "stood still",
     [](Examination& e) {
       e.watch.spin_seconds = {0, 0, 0};
     }},
    {"swap", is_bad, "swapoff", [](Examination& e) { e.facts.swap_used_bytes = 2e8; }},
    {"swap", is_good, "0.1 GB used", [](Examination& e) { e.facts.swap_used_bytes = 0.9e8; }},
    {"swap", is_unknown, "no such file",
     [](Examination& e) { e.facts.swap_used_bytes = not_known<double>(); }},
    {"memory", is_bad, "0.5 GB of 10.0 GB", [](Examination& e) { e.facts.free_memory_bytes = 5e8; }},
    {"memory", is_good, "8.0 GB of 10.0 GB", [](Examination&) {}},
    {"memory", is_unknown, "no such file",
     [](Examination& e) { e.facts.free_memory_bytes = not_known<double>(); }},
};

const Finding& find(const std::vector<Finding>& findings, const std::string& name) {
  for (const Finding& finding : findings)
    if (finding.name == name) return finding;
  throw std::runtime_error("no finding " + name);
}

TEST(findings, each_check_knows_good_bad_and_unknown) {
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name + ": " + c.contains);
    Examination examination = quiet_machine();
    c.change(examination);
    const Finding finding = find(judge(examination), c.name);
    EXPECT_EQ(finding.state, c.state);
    const std::string text = finding.value + "\n" + finding.why + "\n" + finding.advice;
    EXPECT_NE(text.find(c.contains), std::string::npos) << text;
    EXPECT_EQ(finding.advice.empty(), c.state != is_bad) << "advice is for what is bad";
    EXPECT_EQ(finding.why.empty(), c.state == is_good);
    EXPECT_EQ(finding.value.empty(), c.state == is_unknown);
  }
}

TEST(findings, every_check_has_its_three_cases_above) {
  std::set<std::pair<std::string, FindingState>> tried;
  for (const Case& c : cases) tried.emplace(c.name, c.state);
  for (const Finding& finding : judge(quiet_machine()))
    for (const FindingState state : {is_bad, is_unknown, is_good})
      EXPECT_TRUE(tried.contains({finding.name, state})) << finding.name << " " << static_cast<int>(state);
}

TEST(findings, a_quiet_machine_has_nothing_to_mend) {
  const auto findings = judge(quiet_machine());
  for (const Finding& finding : findings) EXPECT_EQ(finding.state, is_good) << finding.name;
  EXPECT_EQ(verdict(findings), "Nothing found that would hide small differences.");
}

TEST(findings, unknown_is_no_warning) {
  const auto findings = judge({});
  for (const Finding& finding : findings) EXPECT_EQ(finding.state, is_unknown) << finding.name;
  EXPECT_EQ(verdict(findings),
            "Nothing found that would hide small differences; 19 things cannot be known here.");
}

TEST(findings, what_is_bad_comes_first_and_the_verdict_names_it) {
  Examination examination = quiet_machine();
  examination.facts.governor = std::string("powersave");
  examination.facts.turbo = not_known<bool>();
  auto findings = judge(examination);
  EXPECT_EQ(findings[0].name, "governor");
  EXPECT_EQ(findings[1].name, "turbo");
  EXPECT_EQ(verdict(findings), "1 thing to mend before you trust small differences: governor.");
  examination.watch.change.steal_share = 1;
  findings = judge(examination);
  EXPECT_EQ(verdict(findings), "2 things to mend before you trust small differences: steal, governor.");
  const std::string text = to_text(table_of(findings));
  EXPECT_LT(text.find("\nbad "), text.find("\nunknown "));
  EXPECT_LT(text.find("\nunknown "), text.find("\ngood "));
  EXPECT_EQ(to_json(findings[0])["state"], "bad");
}

}  // namespace
}  // namespace raysweep
