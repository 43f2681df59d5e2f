// The little languages inside config values.
#include <cmath>
#include <sstream>

#include "experiments/config.h"
#include "experiments/numbers.h"

namespace raysweep {

namespace {

constexpr int max_range_length = 4096;

/// "12", "cores", "pus", "2*pus": one end of a range.
std::optional<int> range_end(std::string_view text, const MachineSize& machine) {
  if (text == "cores") return machine.cores;
  if (text == "pus") return machine.pus;
  const size_t star = text.find('*');
  if (star != std::string_view::npos) {
    const auto factor = parse_number<int>(text.substr(0, star));
    const auto of = range_end(text.substr(star + 1), machine);
    if (!factor || !of || std::abs(*factor) > max_range_length) return std::nullopt;
    return *factor * *of;
  }
  return parse_number<int>(text);
}

}  // namespace

std::vector<int> expand_range(const std::string& text, const MachineSize& machine) {
  const size_t dots = text.find("..");
  const auto low = range_end(std::string_view(text).substr(0, dots), machine);
  const auto high =
      dots == std::string::npos ? low : range_end(std::string_view(text).substr(dots + 2), machine);
  std::vector<int> values;
  if (!low || !high || static_cast<long long>(*high) - *low >= max_range_length) return values;
  for (int v = *low; v <= *high; ++v) values.push_back(v);
  return values;
}

double parse_duration(const std::string& text) {
  std::istringstream in(text);
  double value = 0;
  std::string unit, rest;
  if (!(in >> value >> unit) || (in >> rest) || !std::isfinite(value) || value <= 0) return 0;
  return value * (unit == "s" ? 1 : unit == "min" ? 60 : unit == "h" ? 3600 : 0);
}

}  // namespace raysweep
