// What a module of kernels hands out: the study's formulas, compiled in another way than the program.
#pragma once

#include <vector>

#include "experiments/intersection/kernel.h"

namespace raysweep {

struct KernelModule {
  size_t layout;  // `kernel_layout` of its build
  const std::vector<Kernel<float>>* of_float;
  const std::vector<Kernel<double>>* of_double;
};
/// Another one than the program's: the module is of another build.
inline constexpr size_t kernel_layout = sizeof(Kernel<float>) * 1000 + sizeof(Workload<float>);

inline constexpr const char* kernel_module_symbol = "raysweep_kernel_module";
using KernelModuleFunction = const KernelModule* (*)();

}  // namespace raysweep
