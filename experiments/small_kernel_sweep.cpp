#include "experiments/small_kernel_sweep.h"

#include <fmt/format.h>

#include <cmath>

namespace raysweep {

namespace {

bool is_step_of(const KernelFactor& factor, double number) {
  const double steps = (number - factor.low) / factor.step;
  return std::abs(steps - std::round(steps)) < 1e-9 * std::max(1.0, steps);
}

std::vector<std::string> values_of(TomlReader& reader, const toml::table& sweep, const KernelFactor& factor) {
  if (!factor.names.empty()) return reader.names_or_all(sweep, factor.name, factor.names);
  std::vector<double> numbers = factor.usual;
  if (sweep.contains(factor.name))
    numbers = reader.numbers_or(sweep, factor.name, factor.low, factor.low, factor.high);
  std::vector<std::string> values;
  for (const double number : numbers) {
    if (!is_step_of(factor, number)) {
      reader.fail(*sweep.get(factor.name),
                  fmt::format("{} must be numbers from {} to {} in steps of {}", factor.name,
                              factor_text(factor.low), factor_text(factor.high), factor_text(factor.step)));
    }
    values.push_back(factor_text(number));
  }
  return values;
}

}  // namespace

std::vector<SmallKernelSweep> read_small_kernels(TomlReader& reader, const toml::table& sweep,
                                                 const std::vector<std::string>& kernels) {
  std::vector<std::string_view> known{"kernel"};
  std::vector<SmallKernelSweep> list;
  for (const std::string& name : kernels) {
    const SmallKernel* const kernel = find_small_kernel(name);
    if (!kernel) continue;
    list.push_back({kernel, {}});
    for (const KernelFactor& factor : kernel->factors) {
      known.push_back(factor.name);
      list.back().values.push_back(values_of(reader, sweep, factor));
    }
  }
  reader.check_keys(sweep, "sweep.", known);
  return list;
}

std::vector<SmallKernelCell> cells_of(const SmallKernelSweep& sweep, std::vector<Inapplicable>& left_out) {
  std::vector<SmallKernelCell> cells{{{}, std::string(sweep.kernel->name)}};
  for (size_t i = 0; i < sweep.values.size(); ++i) {
    std::vector<SmallKernelCell> longer;
    for (const SmallKernelCell& cell : cells) {
      for (const std::string& value : sweep.values[i]) {
        longer.push_back({cell.values, cell.key + '/' + value});
        longer.back().values[std::string(sweep.kernel->factors[i].name)] = value;
      }
    }
    cells = std::move(longer);
  }
  std::erase_if(cells, [&](const SmallKernelCell& cell) {
    const std::string reason = sweep.kernel->why_not(cell.values);
    // What is left out is told by method and change, for which kernel and values stand here.
    std::string values = cell.key.substr(sweep.kernel->name.size() + 1);
    if (!reason.empty()) left_out.push_back({sweep.kernel->name, values, "", reason});
    return !reason.empty();
  });
  return cells;
}

}  // namespace raysweep
