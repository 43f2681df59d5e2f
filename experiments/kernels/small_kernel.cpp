#include "experiments/kernels/small_kernel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raysweep {

std::string factor_text(double number) {
  constexpr double exact = 9007199254740992;  // 2⁵³: all whole numbers below are doubles
  if (number == std::round(number) && std::abs(number) < exact)
    return fmt::format("{}", static_cast<int64_t>(number));
  return fmt::format("{:g}", number);
}

double number_of(const FactorValues& values, const std::string& factor) {
  return std::stod(values.at(factor));
}

const std::vector<SmallKernel>& all_small_kernels() {
  static const std::vector<SmallKernel> list{expression_templates_kernel(), virtual_calls_kernel(),
                                             branches_kernel(), dot_products_kernel()};
  return list;
}

const SmallKernel* find_small_kernel(std::string_view name) {
  const auto& all = all_small_kernels();
  const auto found = std::ranges::find(all, name, &SmallKernel::name);
  return found == all.end() ? nullptr : &*found;
}

}  // namespace raysweep
