#include "experiments/machine/machine_state.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "experiments/clock.h"
#include "experiments/machine/control_groups.h"
#include "experiments/machine/kernel_files.h"
#include "experiments/machine/processor_facts.h"

namespace raysweep {

namespace fs = std::filesystem;

namespace {

/// "cpu3" gives 3; none for the sum of all, "cpu", and for other lines.
std::optional<int> processor_of(const std::string& word) {
  if (!word.starts_with("cpu") || word.size() == 3) return std::nullopt;
  return std::atoi(word.c_str() + 3);
}

/// Sums over the lines "cpuN" of the allowed processors, in ticks: user nice system idle iowait irq softirq
/// steal, and guests, which user and nice hold already (proc(5)). They stand first: the long line of
/// interrupts after them is not read.
void add_processor_times(const fs::path& root, const ProcessorSet& allowed, StateCounters& state) {
  const double tick = 1.0 / static_cast<double>(sysconf(_SC_CLK_TCK));
  std::ifstream file(root / "proc/stat");
  for (std::string line; std::getline(file, line) && line.starts_with("cpu");) {
    std::istringstream in(line);
    std::string word;
    in >> word;
    const auto processor = processor_of(word);
    if (!processor || !std::binary_search(allowed.begin(), allowed.end(), *processor)) continue;
    double user = 0, nice = 0, system = 0, idle = 0, waiting = 0, irq = 0, softirq = 0, steal = 0;
    if (!(in >> user >> nice >> system >> idle >> waiting >> irq >> softirq)) continue;
    state.busy_seconds = state.busy_seconds.value_or(0) + (user + nice + system + irq + softirq) * tick;
    if (in >> steal) state.steal_seconds = state.steal_seconds.value_or(0) + steal * tick;
  }
}

/// "some avg10=0.00 avg60=0.00 avg300=0.00 total=1234" in microseconds (kernel document accounting/psi.rst).
std::optional<double> pressure_seconds(const fs::path& root) {
  const auto line = first_line(root / "proc/pressure/cpu");
  if (!line || !line->starts_with("some ")) return std::nullopt;
  const size_t total = line->find("total=");
  if (total == std::string::npos) return std::nullopt;
  return std::strtod(line->c_str() + total + 6, nullptr) * 1e-6;
}

double seconds(const timeval& t) {
  return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_usec) * 1e-6;
}

void add_own_usage(StateCounters& state) {
  rusage usage{};
  if (getrusage(RUSAGE_SELF, &usage) != 0) return;
  state.own_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  state.voluntary_switches = static_cast<double>(usage.ru_nvcsw);
  state.involuntary_switches = static_cast<double>(usage.ru_nivcsw);
  state.major_faults = static_cast<double>(usage.ru_majflt);
}

/// Counters never shrink, but those of two readings may come from two moments within a tick.
std::optional<double> difference(const std::optional<double>& before, const std::optional<double>& after) {
  if (!before || !after) return std::nullopt;
  return std::max(0.0, *after - *before);
}

}  // namespace

StateCounters read_state(const fs::path& root, const ProcessorSet& allowed) {
  StateCounters state;
  state.processors = static_cast<int>(allowed.size());
  state.pressure_seconds = pressure_seconds(root);
  state.throttled_seconds = throttled_seconds(control_groups(root));
  state.thermal_throttles = thermal_throttles(allowed, root);
  // Side by side: these are subtracted from each other.
  add_processor_times(root, allowed, state);
  add_own_usage(state);
  state.wall_seconds = now_seconds();
  return state;
}

LaunchState change_between(const StateCounters& before, const StateCounters& after) {
  LaunchState change;
  const double wall = after.wall_seconds - before.wall_seconds;
  if (!(wall > 0)) return change;
  change.wall_seconds = wall;
  if (wall >= least_window_seconds && before.processors == after.processors && after.processors > 0) {
    if (const auto busy = difference(before.busy_seconds, after.busy_seconds))
      change.other_processors = std::max(0.0, (*busy - (after.own_seconds - before.own_seconds)) / wall);
    if (const auto steal = difference(before.steal_seconds, after.steal_seconds))
      change.steal_share = *steal / (wall * after.processors);
  }
  if (const auto pressure = difference(before.pressure_seconds, after.pressure_seconds))
    change.pressure_share = *pressure / wall;
  change.throttled_seconds = difference(before.throttled_seconds, after.throttled_seconds);
  change.thermal_throttles = difference(before.thermal_throttles, after.thermal_throttles);
  change.voluntary_switches = difference(before.voluntary_switches, after.voluntary_switches);
  change.involuntary_switches = difference(before.involuntary_switches, after.involuntary_switches);
  change.major_faults = difference(before.major_faults, after.major_faults);
  return change;
}

double spin_seconds() {
  constexpr int repeats = 5;
  // A multiplication and an addition that wait for each other take 4 cycles on processors since 2010 (Fog,
  // "Instruction tables"): 0.2 ms at 3 GHz.
  constexpr int steps = 150'000;
  double fastest = std::numeric_limits<double>::infinity();
  uint64_t x = 1;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const double begin = now_seconds();
    for (int i = 0; i < steps; ++i) {
      x = x * 6364136223846793005U + 1442695040888963407U;  // Knuth's generator (TAOCP volume 2, 3.3.4)
      // Says that x may have changed: without it two steps could be made one.
      asm volatile("" : "+r"(x));
    }
    fastest = std::min(fastest, now_seconds() - begin);
  }
  return fastest;
}

}  // namespace raysweep
