#include "experiments/machine/processor_facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "experiments/machine/kernel_files.h"
#include "schedulers/placement.h"

namespace raysweep {

namespace fs = std::filesystem;

namespace {

fs::path folder_of_all(const fs::path& root) { return root / "sys/devices/system/cpu"; }

fs::path folder_of(const fs::path& root, int processor) {
  return folder_of_all(root) / fmt::format("cpu{}", processor);
}

/// Of a file that each processor has.
std::string all_unreadable(const std::string& file) { return unreadable(folder_of_all("") / "cpu*" / file); }

/// "on", "off" (it could be), "not there". `active` says whether any core runs two threads, `control` why not
/// (kernel document ABI/testing/sysfs-devices-system-cpu).
Fact<std::string> smt(const OwnProcessors& own, const fs::path& root) {
  using Text = Fact<std::string>;
  if (own.siblings_allowed) return Text("on");
  const auto active = first_number(folder_of_all(root) / "smt/active");
  if (!active)
    return Text::unknown(unreadable(folder_of_all("") / "smt/active") +
                         ", and hwloc sees no two threads of one core here");
  if (*active > 0) return Text("on");
  const auto control = first_line(folder_of_all(root) / "smt/control");
  return Text(control && (*control == "off" || *control == "forceoff") ? "off" : "not there");
}

Fact<bool> turbo(const fs::path& root) {
  if (const auto off = first_number(folder_of_all(root) / "intel_pstate/no_turbo")) return *off == 0;
  if (const auto on = first_number(folder_of_all(root) / "cpufreq/boost")) return *on != 0;
  return Fact<bool>::unknown(unreadable(folder_of_all("") / "intel_pstate/no_turbo") + ", nor cpufreq/boost");
}

/// What the file of that name under cpufreq says for the allowed processors, each answer once.
Fact<std::string> cpufreq(const OwnProcessors& own, const fs::path& root, const char* name) {
  std::set<std::string> answers;
  for (const int processor : own.allowed)
    if (const auto line = first_line(folder_of(root, processor) / "cpufreq" / name)) answers.insert(*line);
  if (answers.empty()) return Fact<std::string>::unknown(all_unreadable(fmt::format("cpufreq/{}", name)));
  std::string text;
  for (const std::string& answer : answers) text += (text.empty() ? "" : ", ") + answer;
  return text;
}

/// The least (or the most) that the file of that name says for an allowed processor, in hertz.
Fact<double> frequency(const OwnProcessors& own, const fs::path& root, const char* name, bool least) {
  std::optional<double> kilohertz;
  for (const int processor : own.allowed) {
    const auto one = first_number(folder_of(root, processor) / "cpufreq" / name);
    if (!one) continue;
    const double before = kilohertz.value_or(*one);
    kilohertz = least ? std::min(before, *one) : std::max(before, *one);
  }
  if (!kilohertz) return Fact<double>::unknown(all_unreadable(fmt::format("cpufreq/{}", name)));
  return *kilohertz * 1000;
}

/// A list of processors that may be empty.
Fact<std::string> processors_in(const fs::path& root, const char* name) {
  const auto line = first_line(folder_of_all(root) / name);
  if (!line) return Fact<std::string>::unknown(unreadable(folder_of_all("") / name));
  const bool none = line->empty() || *line == "(null)";  // what the kernel prints where it was never set
  return none ? std::string("none") : *line;
}

/// How many a list such as "0-3,8" names.
Fact<int> count_of(const Fact<std::string>& list) {
  if (!list.value) return Fact<int>::unknown(list.reason);
  std::istringstream in(*list.value);
  int count = 0;
  for (std::string range; std::getline(in, range, ',');) {
    std::istringstream bounds(range);
    int first = 0, last = 0;
    char dash = 0;
    if (!(bounds >> first)) return Fact<int>::unknown("no list of processors: " + *list.value);
    count += bounds >> dash >> last ? last - first + 1 : 1;
  }
  return count;
}

/// The kernel names the two halves of it (same rate at every frequency; goes on in every sleep).
Fact<bool> invariant_tsc(const fs::path& root) {
  std::istringstream words(read_kernel_file(root / "proc/cpuinfo").value_or(""));
  bool flags = false, constant = false, nonstop = false;
  for (std::string word; words >> word;) {
    flags = flags || word == "flags";
    constant = constant || word == "constant_tsc";
    nonstop = nonstop || word == "nonstop_tsc";
  }
  if (!flags) return Fact<bool>::unknown("/proc/cpuinfo tells no flags");
  return constant && nonstop;
}

}  // namespace

std::optional<double> thermal_throttles(const std::vector<int>& processors, const fs::path& root) {
  std::optional<double> sum;
  for (const int processor : processors) {
    const auto count = first_number(folder_of(root, processor) / "thermal_throttle/core_throttle_count");
    if (!count) return sum;  // where one has none, none has: no need to look at hundreds
    sum = sum.value_or(0) + *count;
  }
  return sum;
}

void read_processors(const OwnProcessors& own, const fs::path& root, MachineFacts& facts) {
  facts.smt = smt(own, root);
  facts.siblings_allowed = own.siblings_allowed;
  facts.turbo = turbo(root);
  facts.governor = cpufreq(own, root, "scaling_governor");
  facts.scaling_driver = cpufreq(own, root, "scaling_driver");
  facts.min_frequency = frequency(own, root, "scaling_min_freq", true);
  facts.max_frequency = frequency(own, root, "scaling_max_freq", false);
  if (own.allowed.empty()) {
    facts.allowed_processors = Fact<int>::unknown("sched_getaffinity gives none");
    facts.allowed_list = Fact<std::string>::unknown(facts.allowed_processors.reason);
  } else {
    facts.allowed_processors = static_cast<int>(own.allowed.size());
    facts.allowed_list = processor_list(own.allowed);
  }
  facts.online_list = processors_in(root, "online");
  facts.online_processors = count_of(facts.online_list);
  facts.isolated = processors_in(root, "isolated");
  facts.nohz_full = processors_in(root, "nohz_full");
  facts.thermal_throttles = Fact<double>::of(thermal_throttles(own.allowed, root),
                                             all_unreadable("thermal_throttle/core_throttle_count"));
  facts.invariant_tsc = invariant_tsc(root);
}

}  // namespace raysweep
