// Whether the machine is one: virtual machines and containers.
#pragma once

#include "experiments/machine/machine_facts.h"

namespace raysweep {

/// Fills in `virtual_machine` and `container`.
void read_sharing(const std::filesystem::path& root, MachineFacts& facts);

}  // namespace raysweep
