// Checks of what went on while the machine was watched, and just before.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/machine/finding_checks.h"

namespace raysweep {

namespace {

std::string percent(double share) { return fmt::format("{:.1f} %", share * 100); }
std::string gigabytes(double bytes) { return fmt::format("{:.1f} GB", bytes * 1e-9); }

/// "cc1plus (812) 0.95, cc1plus (813) 0.31"
std::string names(const std::vector<BusyProcess>& processes) {
  std::string text;
  for (const BusyProcess& p : processes)
    text += fmt::format("{}{} ({}) {:.2f}", text.empty() ? "" : ", ", p.name, p.id, p.processors);
  return text;
}

const char* const not_told = "the kernel does not tell, or the watch was too short";

}  // namespace

Finding check_throttling(const Examination& e) {
  const char* const name = "throttling";
  const auto quota = e.watch.change.throttled_seconds, heat = e.watch.change.thermal_throttles;
  if (quota.value_or(0) > 0) {
    return bad(
        name, fmt::format("{:.3f} s by the quota", *quota), "threads are stopped in the middle of frames",
        "use fewer threads than the quota has processors, and end what else runs in this control group");
  }
  if (heat.value_or(0) > 0) {
    return bad(name, fmt::format("{:.0f} times by heat", *heat),
               "processors run slower the longer a run lasts",
               "cool the machine, or cap its frequency: `sudo cpupower frequency-set --max 2GHz`");
  }
  if (!quota && !heat) return unknown(name, "neither control groups nor processors count it here");
  return good(name, "none");
}

Finding check_steal(const Examination& e) {
  constexpr double harmful = target_half_width / 2;
  const char* const name = "steal";
  const auto steal = e.watch.change.steal_share;
  if (!steal) return unknown(name, not_told);
  if (*steal <= harmful) return good(name, percent(*steal));
  return bad(name, percent(*steal),
             "the hypervisor gives the processors to other machines, some launches more than others",
             "measure at another hour, or on a host or instance type with processors of its own");
}

Finding check_pressure(const Examination& e) {
  constexpr double harmful = 0.05;  // nothing of ours ran: any task that waited was of others
  const char* const name = "pressure";
  const auto pressure = e.watch.change.pressure_share;
  if (!pressure) return unknown(name, "the kernel has no /proc/pressure/cpu (boot it with psi=1)");
  if (*pressure <= harmful) return good(name, percent(*pressure));
  return bad(name, percent(*pressure),
             "tasks wait for processors although nothing is measured yet: threads of a frame would too",
             "end other work; `cat /proc/pressure/cpu` shows how it goes");
}

Finding check_other_load(const Examination& e) {
  const char* const name = "other load";
  const auto others = e.watch.change.other_processors;
  const Fact<int>& allowed = e.facts.allowed_processors;
  if (!others) return unknown(name, not_told);
  if (!allowed.value) return unknown(name, allowed.reason);
  const std::string value = fmt::format("{:.2f} of {} processors", *others, *allowed.value);
  // What others take of all processors, a frame on all of them takes longer.
  if (*others <= target_half_width * *allowed.value) return good(name, value);
  const std::string busiest = names(e.watch.busiest);
  return bad(
      name, value,
      "frames that use all processors are slower by that share, and by more where threads wait for the last",
      busiest.empty()
          ? "no single process shows: look for interrupts and short-lived processes with `top`"
          : fmt::format("end or wait for what uses most (process, number, processors): {}", busiest));
}

Finding check_load_average(const Examination& e) {
  const char* const name = "load average";
  const Fact<double>& load = e.facts.load_average;
  if (!load.value) return unknown(name, load.reason);
  const std::string value = fmt::format("{:.2f}", *load.value);
  if (*load.value < 1) return good(name, value);
  return bad(name, value, "over the last minute at least one other task wanted a processor all the time",
             "wait a minute after builds and other work; `uptime` shows it sink");
}

Finding check_frequency(const Examination& e) {
  constexpr double harmful = 2 * target_half_width;
  const char* const name = "frequency";
  std::vector<double> spins = e.watch.spin_seconds;
  if (spins.size() < 2) return unknown(name, "the watch was too short");
  std::sort(spins.begin(), spins.end());
  if (!(spins.front() > 0)) return unknown(name, "the clock stood still");
  // Not the slowest of all: one spin may have been interrupted in each of its repeats.
  const double drift = spins[(spins.size() * 9 + 9) / 10 - 1] / spins.front() - 1;
  const std::string value = fmt::format("drifts by {}", percent(drift));
  if (drift <= harmful) return good(name, value);
  return bad(name, value, "the same work takes longer at one time than at another",
             "see turbo, governor and other load here; `sudo cpupower frequency-set -g performance`, and on "
             "laptops the "
             "power supply");
}

Finding check_swap(const Examination& e) {
  constexpr double harmful = 0.01;  // of memory: less is what a system leaves there that nobody misses
  const char* const name = "swap";
  const Fact<double>&used = e.facts.swap_used_bytes, &memory = e.facts.memory_bytes;
  if (!used.value) return unknown(name, used.reason);
  if (!memory.value) return unknown(name, memory.reason);
  if (*used.value <= harmful * *memory.value) return good(name, gigabytes(*used.value) + " used");
  return bad(name, gigabytes(*used.value) + " used",
             "a page that comes back from a disk takes longer than a frame",
             "end what fills the memory, then `sudo swapoff -a && sudo swapon -a`");
}

Finding check_memory(const Examination& e) {
  constexpr double least_share = 0.1;  // below, the kernel begins to take pages back from caches and programs
  const char* const name = "memory";
  const Fact<double>&free = e.facts.free_memory_bytes, &memory = e.facts.memory_bytes;
  if (!free.value) return unknown(name, free.reason);
  if (!memory.value) return unknown(name, memory.reason);
  const std::string value = fmt::format("{} of {} free", gigabytes(*free.value), gigabytes(*memory.value));
  if (*free.value >= least_share * *memory.value) return good(name, value);
  return bad(name, value, "scenes are pushed out of memory, and launches end for lack of it",
             "end what fills it: `ps -e --sort=-rss -o rss,pid,comm | head`");
}

Finding check_noise(const Examination& e) {
  const char* const name = "noise (A/A test)";
  if (!e.noise.log_ratio) return unknown(name, e.noise_unknown);
  const double share = std::expm1(*e.noise.log_ratio);
  const std::string value = fmt::format("{} between {} launches and {} of the same, 95 times of 100",
                                        percent(share), noise_launches, noise_launches);
  if (share <= target_half_width) return good(name, value);
  return bad(name, value,
             "smaller differences between two cells cannot be told from chance with so few launches",
             "mend what else is found here; or raise measure.launches: four times as many see half as much");
}

}  // namespace raysweep
