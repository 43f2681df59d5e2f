// What does not change while a run lasts, or hardly: what the machine is, and how it is set up. Read from
// /proc and /sys alone; no other program is started.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "experiments/machine/fact.h"

namespace raysweep {

struct MachineFacts {
  // Processors.
  Fact<std::string> smt;        // "on", "off", "not there"
  Fact<bool> siblings_allowed;  // two hardware threads of one core are among the allowed processors
  Fact<bool> turbo;
  Fact<std::string> governor;  // of the allowed processors; where they differ all, with commas between
  Fact<std::string> scaling_driver;
  Fact<double> min_frequency, max_frequency;  // what the governor may choose from, in hertz
  Fact<int> allowed_processors, online_processors;
  Fact<std::string> allowed_list, online_list;  // "0-3,8"
  Fact<std::string> isolated, nohz_full;        // lists of processors, or "none"
  Fact<double> thermal_throttles;               // since the machine was started
  // Who shares them out.
  Fact<std::string> virtual_machine, container;  // "no", or which, or "yes" and by what it shows
  Fact<double> quota;                            // processors; infinite: not limited
  Fact<double> throttled_seconds;                // of the control groups so far
  Fact<double> load_average;                     // of one minute
  // Clocks.
  Fact<std::string> clock_source;  // of the kernel
  Fact<bool> invariant_tsc;
  // Memory.
  Fact<double> memory_bytes, free_memory_bytes, swap_used_bytes;  // free: without swapping
  Fact<std::string> huge_pages;                                   // transparent: "always", "madvise", "never"
  Fact<bool> layout_random;  // address space layout randomisation, for this process
  Fact<std::string> kernel;
};

/// What the process knows of itself without files.
struct OwnProcessors {
  std::vector<int> allowed;       // by sched_getaffinity; empty: unknown
  bool siblings_allowed = false;  // as hwloc sees it
};

[[nodiscard]] MachineFacts read_machine_facts(const OwnProcessors& own,
                                              const std::filesystem::path& root = "/");

/// {"name": {"state": "yes" | "no" | "unknown" | the value, "reason": …}, …}
[[nodiscard]] nlohmann::json to_json(const MachineFacts& facts);

}  // namespace raysweep
