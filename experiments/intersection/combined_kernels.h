// Kernels of one method in which several factors change at once, for its module.
#pragma once

#include <vector>

#include "experiments/intersection/kernel.h"

namespace raysweep {

/// Those of one of the tracer's methods, one ray and triangle at a time or in lanes, as their file is
/// compiled. Specialised in combined_kernels.cpp, once for each method.
template <class Method, class T>
void add_combined(std::vector<Kernel<T>>& kernels);

}  // namespace raysweep
