// The processors of a machine and how they hang together, by hwloc.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

struct hwloc_topology;

namespace raysweep {

/// What the operating system calls a processor (hwloc's PU).
struct HardwareThread {
  int processor;  // the operating system's number
  int core;       // physical core, counted from 0 in hwloc's order
  int sibling;    // which hardware thread of its core: 0, 1, …
  int package;    // counted from 0
  int cache;      // last level of cache, counted from 0; −1: unknown
  int speed;      // kind of core, higher is faster; 0 where all are alike or nobody knows
};

/// The part of a machine that a process may use.
struct Topology {
  std::vector<HardwareThread> hardware_threads;  // in hwloc's order: neighbours share the most
  std::string cpu;                               // its name
  std::vector<std::string> outline;              // one object a line, indented

  [[nodiscard]] int processors() const { return static_cast<int>(hardware_threads.size()); }
  [[nodiscard]] std::vector<int> processor_numbers() const;  // ascending
  [[nodiscard]] int cores() const;
  [[nodiscard]] int packages() const;
  [[nodiscard]] bool has_smt() const { return processors() > cores(); }
  /// Null for a processor that is not in it.
  [[nodiscard]] const HardwareThread* find(int processor) const;
};

/// This machine, restricted to the processors that this process may use. HWLOC_SYNTHETIC in the environment
/// describes another one. Throws TopologyError if hwloc cannot read it.
[[nodiscard]] Topology this_topology();

/// A machine by hwloc's synthetic description: "pack:1 core:6 pu:2". Throws TopologyError.
[[nodiscard]] Topology synthetic_topology(const std::string& description);

/// What hwloc has loaded.
[[nodiscard]] Topology read_topology(hwloc_topology* loaded);

struct TopologyError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace raysweep
