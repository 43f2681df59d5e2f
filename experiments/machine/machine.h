// What the machine is, as far as a process can see.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "experiments/config.h"
#include "experiments/machine/machine_facts.h"
#include "results/record.h"
#include "schedulers/placement.h"
#include "schedulers/topology.h"

namespace raysweep {

struct Machine {
  std::string host, kernel, compiler;
  Topology topology;            // what this process may use of it
  std::optional<double> quota;  // processors that the control group allows; none: unlimited or unknown
  MachineFacts facts;

  [[nodiscard]] MachineSize size() const {
    return {topology.cores(), topology.processors(), topology.processor_numbers(),
            hyper_threading_placements(topology)};
  }
};

/// Throws TopologyError if hwloc cannot read the topology. HWLOC_SYNTHETIC in the environment describes
/// another machine.
[[nodiscard]] Machine detect_machine();

/// The machine for a record, with its load average now.
[[nodiscard]] MachineRecord machine_record(const Machine& machine);

/// All of it, with the timer (calibrated at the first call, which takes 50 ms) and the build.
[[nodiscard]] nlohmann::json to_json(const Machine& machine);

}  // namespace raysweep
