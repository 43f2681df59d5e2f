// Loops over vectors of four floats by Highway, each compiled for every instruction set and run by the best
// one of this processor.
#pragma once

#include <cstdint>

namespace raysweep {

class CycleTimer;

/// Evaluates `(a + b) · c − d · e` for `count` times, with operands of `sets` sets of 20 floats in turn;
/// `sets` is a power of 2. The last result is left in `result`, 4 floats.
void highway_evaluate(const float* operands, uint64_t sets, uint64_t count, float* result);
/// The same, each evaluation timed by itself.
void highway_evaluate_timed(const float* operands, uint64_t sets, uint64_t count, float* result,
                            CycleTimer& timer);

/// products[i] = (a₀b₀ + a₁b₁) + (a₂b₂ + a₃b₃) of the i-th four floats of `a` and `b`.
void highway_dot_products(const float* a, const float* b, uint64_t count, float* products);

}  // namespace raysweep
