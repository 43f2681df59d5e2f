// Numbers as people read them.
#pragma once

#include <string>

namespace raysweep {

/// Four significant digits, as published tables print them.
[[nodiscard]] std::string significant(double value);

}  // namespace raysweep
