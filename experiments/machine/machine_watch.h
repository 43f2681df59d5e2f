// Looking at the machine for a while, doing next to nothing: what is going on when nothing of ours does?
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "experiments/machine/machine_state.h"

namespace raysweep {

/// A process and the processors that it used on average.
struct BusyProcess {
  int id = 0;
  std::string name;
  double processors = 0;
};

struct MachineWatch {
  LaunchState change;
  std::vector<double> spin_seconds;  // a reading every 50 ms
  std::vector<BusyProcess> busiest;  // the most at first, at most 5, without this one
};

/// Processor time of a process so far.
struct ProcessTime {
  std::string name;
  double seconds = 0;
};

/// All processes, by number. Empty where /proc cannot be read.
[[nodiscard]] std::map<int, ProcessTime> process_times(const std::filesystem::path& root = "/");

/// Who used processors between two readings `seconds` apart, but for the process `but`: the most first, at
/// most 5, none that used less than 1 % of one.
[[nodiscard]] std::vector<BusyProcess> busiest_between(const std::map<int, ProcessTime>& before,
                                                       const std::map<int, ProcessTime>& after,
                                                       double seconds, int but);

/// Takes `seconds`.
[[nodiscard]] MachineWatch watch_machine(double seconds, const std::filesystem::path& root = "/");

}  // namespace raysweep
