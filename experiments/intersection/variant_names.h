// Names of a variant's factors and of what is changed in it, as records have them.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "tracer/intersect/variant.h"

namespace raysweep {

struct FactorName {
  std::string_view factor, value;
};

/// The values of a variant's factors.
[[nodiscard]] constexpr std::array<FactorName, 7> factor_names(const Variant& v) {
  const auto* const early_out = v.early_out == EarlyOut::yes  ? "yes"
                                : v.early_out == EarlyOut::no ? "no"
                                                              : "folded";
  const auto* const output = v.output == Output::hit ? "hit" : v.output == Output::t ? "t" : "weights";
  const auto* const data = v.data == Data::bare          ? "bare"
                           : v.data == Data::precomputed ? "precomputed"
                                                         : "from_double";
  return {{{"division", v.division == Division::early ? "early" : "late"},
           {"reciprocal", v.reciprocal == Reciprocal::exact ? "exact" : "newton"},
           {"order", v.order == Order::distance_first ? "distance_first" : "weights_first"},
           {"edges", v.edges == Edges::inclusive ? "inclusive" : "strict"},
           {"early_out", early_out},
           {"output", output},
           {"data", data}}};
}

/// How many factors differ.
[[nodiscard]] constexpr size_t change_count(const Variant& base, const Variant& variant) {
  const auto before = factor_names(base), after = factor_names(variant);
  size_t count = 0;
  for (size_t i = 0; i < before.size(); ++i) count += before[i].value == after[i].value ? 0 : 1;
  return count;
}

/// What differs from `base`: "division=late", or "division=late,edges=strict"; "base" where nothing does.
[[nodiscard]] inline std::string change_of(const Variant& base, const Variant& variant) {
  const auto before = factor_names(base), after = factor_names(variant);
  std::string change;
  for (size_t i = 0; i < before.size(); ++i) {
    if (before[i].value == after[i].value) continue;
    if (!change.empty()) change += ',';
    change.append(after[i].factor).append("=").append(after[i].value);
  }
  return change.empty() ? "base" : change;
}

}  // namespace raysweep
