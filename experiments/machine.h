// What the machine is, as far as a process can see.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "experiments/config.h"
#include "results/record.h"

namespace raysweep {

/// Counts are of what this process may use (its affinity), by hwloc.
struct Machine {
  std::string host, cpu, kernel, compiler;
  int packages = 0, cores = 0, pus = 0;
  std::optional<double> quota;       // processors that the control group allows; none: unlimited or unknown
  std::vector<std::string> outline;  // the topology, one object a line, indented

  [[nodiscard]] MachineSize size() const { return {cores, pus}; }
};

/// Throws WorkError if hwloc cannot read the topology. HWLOC_SYNTHETIC in the environment describes another
/// machine.
[[nodiscard]] Machine detect_machine();

/// The machine for a record, with its load average now.
[[nodiscard]] MachineRecord machine_record(const Machine& machine);

[[nodiscard]] nlohmann::json to_json(const Machine& machine);

}  // namespace raysweep
