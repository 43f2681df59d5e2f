// Data of the expressions, the same numbers whatever they are held in.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "experiments/kernels/small_kernel.h"
#include "experiments/kernels/vec4.h"
#include "experiments/machine/cycle_timer.h"

namespace raysweep {

/// a to e of one evaluation.
using Operands = std::array<FourFloats, 5>;

/// Evaluations take them in turn: few enough that even those with memory of their own stay in the first
/// cache. A power of 2.
constexpr uint64_t operand_count = 64;

[[nodiscard]] std::vector<Operands> random_operands(uint64_t seed);

/// What `expression` is of these: each lane by itself, by plain floats.
[[nodiscard]] FourFloats expected_of(const Operands& operands);

/// The clause of results that differ from `expected_of`, which holds for each bit; empty where none does.
[[nodiscard]] std::string why_results_wrong(const std::vector<Operands>& operands,
                                            const std::vector<FourFloats>& results);

[[nodiscard]] TickRecord tick_record(const CycleTimer& timer);

/// Evaluated in Highway's vectors of 128 bits, by the best instruction set of this processor.
[[nodiscard]] std::unique_ptr<SmallPass> highway_expressions(uint64_t evaluations, uint64_t seed);

}  // namespace raysweep
