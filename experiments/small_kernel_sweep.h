// What an experiment asks of kernels other than intersection.
#pragma once

#include <string>
#include <vector>

#include "experiments/intersection/subjects.h"
#include "experiments/kernels/small_kernel.h"
#include "experiments/toml_reader.h"

namespace raysweep {

struct SmallKernelSweep {
  const SmallKernel* kernel = nullptr;
  std::vector<std::vector<std::string>> values;  // of each of its factors, in their order
};

/// A kernel in one of its ways.
struct SmallKernelCell {
  FactorValues values;
  std::string key;  // "expression_templates/valarray/1000"
};

/// Reads from [sweep] the factors of `kernels`; every other key is an error.
[[nodiscard]] std::vector<SmallKernelSweep> read_small_kernels(TomlReader& reader, const toml::table& sweep,
                                                               const std::vector<std::string>& kernels);

/// Every combination. Of those that cannot be timed here the reasons are added to `left_out`.
[[nodiscard]] std::vector<SmallKernelCell> cells_of(const SmallKernelSweep& sweep,
                                                    std::vector<Inapplicable>& left_out);

}  // namespace raysweep
