// The little languages inside config values.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "experiments/config.h"
#include "experiments/numbers.h"
#include "schedulers/registry.h"
#include "tracer/wide/isa.h"

namespace raysweep {

namespace {

constexpr int max_range_length = 4096;

/// "12", "cores", "pus", "2*pus": one end of a range; none beyond ±2²⁰.
std::optional<int> range_end(std::string_view text, const MachineSize& machine) {
  constexpr int limit = 1 << 20;
  std::optional<long long> value;
  const size_t star = text.find('*');
  if (text == "cores") {
    value = std::min(machine.cores, max_threads);
  } else if (text == "pus") {
    value = std::min(machine.pus, max_threads);
  } else if (star != std::string_view::npos) {
    const auto factor = range_end(text.substr(0, star), machine),
               of = range_end(text.substr(star + 1), machine);
    if (factor && of) value = static_cast<long long>(*factor) * *of;
    // "2*pus" asks for what can be had: a machine of 768 processors must not make its config invalid.
    const bool of_machine = text.ends_with("cores") || text.ends_with("pus");
    if (value && of_machine) value = std::min<long long>(*value, max_threads);
  } else {
    value = parse_number<int>(text);
  }
  if (!value || *value > limit || *value < -limit) return std::nullopt;
  return static_cast<int>(*value);
}

}  // namespace

std::vector<int> expand_range(const std::string& text, const MachineSize& machine) {
  const size_t dots = text.find("..");
  const auto low = range_end(std::string_view(text).substr(0, dots), machine);
  const auto high =
      dots == std::string::npos ? low : range_end(std::string_view(text).substr(dots + 2), machine);
  std::vector<int> values;
  if (!low || !high || *high - *low >= max_range_length) return values;
  for (int v = *low; v <= *high; ++v) values.push_back(v);
  return values;
}

std::vector<std::string> expand_value(const std::string& text, std::string_view name, bool numeric,
                                      const MachineSize& machine) {
  std::vector<std::string> values;
  if (numeric) {
    for (const int v : expand_range(text, machine)) values.push_back(std::to_string(v));
  } else if (name == "isa" && text == "all") {
    for (const Isa& isa : built_isas()) {
      if (runs_here(isa.name)) values.emplace_back(isa.name);
    }
  }
  if (values.empty()) values.push_back(text);
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
