#include "experiments/machine/machine_facts.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "experiments/machine/control_groups.h"
#include "experiments/machine/kernel_files.h"
#include "experiments/machine/processor_facts.h"
#include "experiments/machine/sharing_facts.h"

namespace raysweep {

namespace fs = std::filesystem;

namespace {

template <class T>
Fact<T> or_missing(std::optional<T> value, const fs::path& file) {
  return Fact<T>::of(std::move(value), unreadable(file));
}

Fact<std::string> line_of(const fs::path& root, const char* file) {
  return or_missing(first_line(root / file), file);
}

/// The word in brackets: "always [madvise] never".
Fact<std::string> huge_pages(const fs::path& root) {
  const char* const file = "sys/kernel/mm/transparent_hugepage/enabled";
  Fact<std::string> line = line_of(root, file);
  if (!line.value) return line;
  const size_t begin = line.value->find('['), end = line.value->find(']');
  if (begin == std::string::npos || end == std::string::npos || end < begin)
    return Fact<std::string>::unknown(fmt::format("/{} names no choice", file));
  return line.value->substr(begin + 1, end - begin - 1);
}

/// The system's setting (0: off; kernel document admin-guide/sysctl/kernel.rst), and what `setarch -R` asks
/// for one process (ADDR_NO_RANDOMIZE of <linux/personality.h>).
Fact<bool> layout_random(const fs::path& root) {
  constexpr unsigned long no_randomize = 0x0040000;
  const char* const file = "proc/sys/kernel/randomize_va_space";
  const auto setting = first_number(root / file);
  if (!setting) return Fact<bool>::unknown(unreadable(file));
  const auto personality = first_line(root / "proc/self/personality");
  const bool refused = personality && (std::strtoul(personality->c_str(), nullptr, 16) & no_randomize) != 0;
  return *setting > 0 && !refused;
}

void read_memory(const fs::path& root, MachineFacts& facts) {
  const char* const file = "proc/meminfo";
  const auto bytes = [&](const char* key) -> std::optional<double> {
    const auto kilobytes = keyed_number(root / file, key);
    if (!kilobytes) return std::nullopt;
    return *kilobytes * 1024;
  };
  facts.memory_bytes = or_missing(bytes("MemTotal"), file);
  facts.free_memory_bytes = or_missing(bytes("MemAvailable"), file);
  const auto total = bytes("SwapTotal"), free = bytes("SwapFree");
  facts.swap_used_bytes =
      total && free ? Fact<double>(*total - *free) : Fact<double>::unknown(unreadable(file));
}

void read_groups(const fs::path& root, MachineFacts& facts) {
  const ControlGroups groups = control_groups(root);
  facts.quota = Fact<double>::of(cpu_quota(groups), "no control group of this process can be read");
  facts.throttled_seconds =
      Fact<double>::of(throttled_seconds(groups), "no control group of this process counts it");
}

nlohmann::json state_of(bool value) { return value ? "yes" : "no"; }
nlohmann::json state_of(int value) { return value; }
nlohmann::json state_of(const std::string& value) { return value; }
nlohmann::json state_of(double value) {
  if (std::isfinite(value)) return value;
  return "unlimited";  // JSON has no infinity
}

template <class T>
nlohmann::json to_json(const Fact<T>& fact) {
  if (!fact.value) return {{"state", "unknown"}, {"reason", fact.reason}};
  return {{"state", state_of(*fact.value)}, {"reason", fact.reason}};
}

}  // namespace

MachineFacts read_machine_facts(const OwnProcessors& own, const fs::path& root) {
  MachineFacts facts;
  read_processors(own, root, facts);
  read_sharing(root, facts);
  read_groups(root, facts);
  read_memory(root, facts);
  facts.load_average = or_missing(first_number(root / "proc/loadavg"), "proc/loadavg");
  facts.clock_source = line_of(root, "sys/devices/system/clocksource/clocksource0/current_clocksource");
  facts.huge_pages = huge_pages(root);
  facts.layout_random = layout_random(root);
  facts.kernel = line_of(root, "proc/sys/kernel/osrelease");
  return facts;
}

nlohmann::json to_json(const MachineFacts& f) {
  return {{"smt", to_json(f.smt)},
          {"siblings_allowed", to_json(f.siblings_allowed)},
          {"turbo", to_json(f.turbo)},
          {"governor", to_json(f.governor)},
          {"scaling_driver", to_json(f.scaling_driver)},
          {"min_frequency", to_json(f.min_frequency)},
          {"max_frequency", to_json(f.max_frequency)},
          {"allowed_processors", to_json(f.allowed_processors)},
          {"online_processors", to_json(f.online_processors)},
          {"allowed_list", to_json(f.allowed_list)},
          {"online_list", to_json(f.online_list)},
          {"isolated", to_json(f.isolated)},
          {"nohz_full", to_json(f.nohz_full)},
          {"thermal_throttles", to_json(f.thermal_throttles)},
          {"virtual_machine", to_json(f.virtual_machine)},
          {"container", to_json(f.container)},
          {"quota", to_json(f.quota)},
          {"throttled_seconds", to_json(f.throttled_seconds)},
          {"load_average", to_json(f.load_average)},
          {"clock_source", to_json(f.clock_source)},
          {"invariant_tsc", to_json(f.invariant_tsc)},
          {"memory_bytes", to_json(f.memory_bytes)},
          {"free_memory_bytes", to_json(f.free_memory_bytes)},
          {"swap_used_bytes", to_json(f.swap_used_bytes)},
          {"huge_pages", to_json(f.huge_pages)},
          {"layout_random", to_json(f.layout_random)},
          {"kernel", to_json(f.kernel)}};
}

}  // namespace raysweep
