// Numbers as people read them, and as programs do.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "results/statistics/statistics.h"

namespace raysweep {

/// Four significant digits, as published tables print them.
[[nodiscard]] std::string significant(double value);

/// "1.984 [1.952, 2.012]", or without brackets where there is no interval; "–" for none.
[[nodiscard]] std::string with_interval(const std::optional<Estimate>& estimate);

/// "99 %"; "–" for none.
[[nodiscard]] std::string percent(const std::optional<double>& value);

/// "99.1 % [98.0, 100.2]"
[[nodiscard]] std::string percent(const std::optional<Estimate>& estimate);

/// Every digit; empty for none.
[[nodiscard]] std::string unrounded(const std::optional<double>& value);

/// The value and its interval's ends.
[[nodiscard]] std::array<std::string, 3> unrounded(const std::optional<Estimate>& estimate);

}  // namespace raysweep
