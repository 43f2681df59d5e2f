// The modules of kernels that this program has: the study's formulas in lanes, and by other compilers and
// flags.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "experiments/intersection/kernel_module.h"

namespace raysweep {

struct KernelModuleInfo {
  std::string_view name;     // "avx2"; of the file kernels_avx2.so
  std::string_view summary;  // what is different there
};

/// All that this project can build on some processor, those that are not available here included.
[[nodiscard]] std::span<const KernelModuleInfo> all_kernel_modules();

/// Why a module cannot be used here, as "is not built: …"; empty if it can.
[[nodiscard]] std::string why_no_kernels(std::string_view name);

/// The module, loaded; it stays. Throws std::runtime_error if it cannot be used.
[[nodiscard]] const KernelModule& load_kernels(std::string_view name);

/// The best instruction set among the modules that can be used here; empty without any.
[[nodiscard]] std::string_view best_lanes();

}  // namespace raysweep
