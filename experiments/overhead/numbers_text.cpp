#include "experiments/overhead/numbers_text.h"

#include <fmt/format.h>

#include <cmath>

#include "results/tables/number_text.h"

namespace raysweep {

std::string duration_text(double nanoseconds) {
  const double size = std::abs(nanoseconds);
  if (size < 1e3) return significant(nanoseconds) + " ns";
  if (size < 1e6) return significant(nanoseconds / 1e3) + " µs";
  if (size < 1e9) return significant(nanoseconds / 1e6) + " ms";
  return significant(nanoseconds / 1e9) + " s";
}

std::string duration_text(const Estimate& nanoseconds) {
  std::string text = duration_text(nanoseconds.value);
  if (!nanoseconds.interval) return text;
  const auto& [low, high] = *nanoseconds.interval;
  return fmt::format("{} [{}, {}]", text, duration_text(low), duration_text(high));
}

std::string digits(double value) { return fmt::format("{:.6g}", value); }

void add_columns(Table& table, const std::string& name) {
  for (const char* end : {"", "_low", "_high"}) table.columns.push_back({name + end});
}

void add_cells(std::vector<std::string>& cells, const std::optional<Estimate>& estimate) {
  const bool interval = estimate && estimate->interval;
  cells.push_back(estimate ? digits(estimate->value) : "");
  cells.push_back(interval ? digits(estimate->interval->low) : "");
  cells.push_back(interval ? digits(estimate->interval->high) : "");
}

}  // namespace raysweep
