#include "results/tables/number_text.h"

#include <fmt/format.h>

#include <cmath>

namespace raysweep {

std::string significant(double value) {
  const double size = std::abs(value);
  const int decimals = size >= 1000 ? 0 : size >= 100 ? 1 : size >= 10 ? 2 : 3;
  return fmt::format("{:.{}f}", value, decimals);
}

std::string with_interval(const std::optional<Estimate>& e) {
  if (!e) return "–";
  if (!e->interval) return significant(e->value);
  return fmt::format("{} [{}, {}]", significant(e->value), significant(e->interval->low),
                     significant(e->interval->high));
}

std::string percent(const std::optional<double>& v) { return v ? fmt::format("{:.0f} %", *v * 100) : "–"; }

std::string percent(const std::optional<Estimate>& e) {
  if (!e) return "–";
  if (!e->interval) return fmt::format("{:.1f} %", e->value * 100);
  return fmt::format("{:.1f} % [{:.1f}, {:.1f}]", e->value * 100, e->interval->low * 100,
                     e->interval->high * 100);
}

std::string unrounded(const std::optional<double>& v) { return v ? fmt::format("{}", *v) : std::string(); }

std::array<std::string, 3> unrounded(const std::optional<Estimate>& e) {
  if (!e) return {};
  if (!e->interval) return {fmt::format("{}", e->value), "", ""};
  return {fmt::format("{}", e->value), fmt::format("{}", e->interval->low),
          fmt::format("{}", e->interval->high)};
}

}  // namespace raysweep
