// What the runtimes of schedulers read from the environment.
#pragma once

#include <span>
#include <string_view>

namespace raysweep {

/// How the names of such variables begin.
[[nodiscard]] std::span<const std::string_view> runtime_variables();
[[nodiscard]] bool is_runtime_variable(std::string_view name);

/// Takes them out of this process: the cell alone says what runtimes are told.
void forget_runtime_variables();

}  // namespace raysweep
