#include "results/claims/observation.h"

#include <charconv>
#include <cmath>

namespace raysweep {

namespace {

/// The number, and how many characters it takes; 0 for none.
std::pair<double, size_t> number_before(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  // "inf" and "nan" are names here.
  if (error != std::errc() || !std::isfinite(value)) return {0, 0};
  return {value, static_cast<size_t>(end - text.data())};
}

}  // namespace

Observation observation_of(std::map<int, double> by_round) {
  Observation made;
  std::vector<double> samples;
  for (const auto& [round, value] : by_round) samples.push_back(value);
  if (!samples.empty()) made.value = estimate_median(std::move(samples));
  made.by_round = std::move(by_round);
  return made;
}

Observation exact_observation(double value) {
  Observation made;
  made.exact = true;
  made.value.value = value;
  made.value.interval = Estimate::Bounds{value, value};
  made.value.count = 1;
  return made;
}

Observations observations_of(const std::vector<MeasuredCell>& cells) {
  Observations list;
  for (const MeasuredCell& cell : cells) {
    for (const auto& [quantity, value] : cell.values) {
      Observation& made = list[quantity].emplace_back(value);
      made.factors = cell.factors;
    }
  }
  return list;
}

std::optional<double> leading_number(const std::string& text) {
  const auto [value, length] = number_before(text);
  return length > 0 ? std::optional(value) : std::nullopt;
}

bool is_number(const std::string& text) {
  const size_t length = number_before(text).second;
  return length > 0 && length == text.size();
}

bool is_same_value(const std::string& a, const std::string& b) {
  return a == b || (is_number(a) && is_number(b) && leading_number(a) == leading_number(b));
}

bool is_value_before(const std::string& a, const std::string& b) {
  const auto x = leading_number(a), y = leading_number(b);
  return x && y && *x != *y ? *x < *y : a < b;
}

}  // namespace raysweep
