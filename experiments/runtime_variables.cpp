#include "experiments/runtime_variables.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <vector>

namespace raysweep {

std::span<const std::string_view> runtime_variables() {
  static constexpr std::array<std::string_view, 4> prefixes{"OMP_", "GOMP_", "KMP_", "TBB_"};
  return prefixes;
}

bool is_runtime_variable(std::string_view name) {
  return std::ranges::any_of(runtime_variables(),
                             [&](std::string_view prefix) { return name.starts_with(prefix); });
}

void forget_runtime_variables() {
  std::vector<std::string> names;
  for (char** variable = environ; *variable; ++variable) {
    const std::string_view entry = *variable;
    if (is_runtime_variable(entry)) names.emplace_back(entry.substr(0, entry.find('=')));
  }
  for (const std::string& name : names) unsetenv(name.c_str());
}

}  // namespace raysweep
