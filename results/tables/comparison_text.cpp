#include "results/tables/comparison_text.h"

#include <fmt/format.h>

#include <cmath>

namespace raysweep {

namespace {

std::string signed_number(double ratio) {
  const double percent = (ratio - 1) * 100;
  const std::string size = fmt::format("{:.1f}", std::abs(percent));
  return size == "0.0" ? size : fmt::format("{}{}", percent < 0 ? "−" : "+", size);
}

std::string floor_text(const NoiseFloor& floor) {
  return floor.log_ratio ? fmt::format("noise floor {:.2g} %", std::expm1(*floor.log_ratio) * 100)
                         : "noise floor unknown";
}

/// What a claim must be read with where no floor is known.
std::string but_unknown(const NoiseFloor& floor) { return floor.log_ratio ? "" : " (noise floor unknown)"; }

}  // namespace

std::string signed_percent(double ratio) { return signed_number(ratio) + " %"; }

std::string amount(const Change& change) {
  const bool more = change.ratio > 1;
  const auto [low, high] = change.interval;
  const double least = more ? low - 1 : 1 - high, most = more ? high - 1 : 1 - low;
  const int decimals = std::abs(least) < 0.1 ? 1 : 0;
  return fmt::format("{:.{}f} % [{:.{}f}, {:.{}f}]", std::abs(change.ratio - 1) * 100, decimals, least * 100,
                     decimals, most * 100, decimals);
}

std::string signed_amount(const Change& change) {
  return fmt::format("{} [{}, {}]", signed_percent(change.ratio), signed_number(change.interval.low),
                     signed_number(change.interval.high));
}

std::string in_words(const std::optional<Change>& change, const NoiseFloor& floor) {
  switch (verdict_of(change, floor)) {
    case Verdict::faster:
      return "faster by " + amount(*change) + but_unknown(floor);
    case Verdict::slower:
      return "slower by " + amount(*change) + but_unknown(floor);
    case Verdict::no_difference:
      return "no difference shown";
    case Verdict::too_few:
      break;
  }
  return "too few launches";
}

std::string in_a_sentence(const std::string& name, const std::string& base_name,
                          const std::optional<Change>& change, const NoiseFloor& floor) {
  const Verdict verdict = verdict_of(change, floor);
  if (verdict == Verdict::too_few) return "too few launches to compare: fewer than 6";
  if (verdict != Verdict::no_difference) {
    return fmt::format("{} is {} than {} by {}{}", name, to_string(verdict), base_name, amount(*change),
                       floor.log_ratio ? "" : ", noise floor unknown");
  }
  const std::string shown = "no difference shown: " + signed_amount(*change);
  if (floor.log_ratio && excludes_one(*change))
    return fmt::format("{} is below the noise floor of {:.2g} %", shown, std::expm1(*floor.log_ratio) * 100);
  return fmt::format("{}, {}", shown, floor_text(floor));
}

}  // namespace raysweep
