// Times and intervals, for people and for machines.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/statistics/statistics.h"
#include "results/tables/table.h"

namespace raysweep {

/// "12.34 ns", "1.234 µs", "12.34 ms" or "1.234 s", of nanoseconds.
[[nodiscard]] std::string duration_text(double nanoseconds);

/// "1.234 µs [1.200 µs, 1.300 µs]", of nanoseconds.
[[nodiscard]] std::string duration_text(const Estimate& nanoseconds);

/// Six significant digits.
[[nodiscard]] std::string digits(double value);

/// Three columns: NAME, NAME_low, NAME_high.
void add_columns(Table& table, const std::string& name);

/// Their cells: empty where there is no estimate or no interval.
void add_cells(std::vector<std::string>& cells, const std::optional<Estimate>& estimate);

}  // namespace raysweep
