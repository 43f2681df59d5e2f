#include "results/claims/groups.h"

#include <fmt/format.h>

#include <algorithm>

namespace raysweep {

namespace {

const std::string no_use = "-";

std::string value_of(const Observation& observation, const std::string& factor) {
  const auto found = observation.factors.find(factor);
  return found == observation.factors.end() ? no_use : found->second;
}

/// What a formula of the machine stands for; the text itself of any other.
std::string resolved(const std::string& value, const MachineCounts& machine) {
  if (!mentions_machine(value)) return value;
  try {
    return fmt::format("{}", evaluate(value, machine));
  } catch (const ExpressionError&) {
    return value;
  }
}

/// Names that people think in come first: they are kept where one of two factors decides the other.
std::vector<std::string> by_preference(const std::set<std::string>& names) {
  static const std::vector<std::string> first{"mode",     "scene",     "scheduler", "threads",
                                              "kernel",   "method",    "change",    "precision",
                                              "protocol", "parameter", "case",      "difficulty"};
  std::vector<std::string> ordered;
  for (const std::string& name : first) {
    if (names.contains(name)) ordered.push_back(name);
  }
  for (const std::string& name : names) {
    if (std::ranges::find(first, name) == first.end()) ordered.push_back(name);
  }
  return ordered;
}

std::set<std::string> varying(const ObservationList& list) {
  std::map<std::string, std::set<std::string>> values;
  for (const Observation* const one : list) {
    for (const auto& [name, value] : one->factors) values[name].insert(value);
  }
  std::set<std::string> names;
  for (auto& [name, of_one] : values) {
    of_one.erase(no_use);
    if (of_one.size() > 1) names.insert(name);
  }
  return names;
}

/// Whether observations that agree in `others` agree in `factor` too.
bool is_decided(const std::string& factor, const std::vector<std::string>& others,
                const ObservationList& list) {
  std::map<std::vector<std::string>, std::string> known;
  for (const Observation* const one : list) {
    std::vector<std::string> key;
    for (const std::string& name : others) key.push_back(value_of(*one, name));
    const std::string value = value_of(*one, factor);
    if (known.emplace(std::move(key), value).first->second != value) return false;
  }
  return true;
}

}  // namespace

bool has_value(const Observation& observation, const std::string& factor, const std::string& value,
               const MachineCounts& machine) {
  const std::string own = value_of(observation, factor);
  return own == no_use || is_same_value(own, value) || is_same_value(own, resolved(value, machine));
}

bool has_values(const Observation& observation, const Factors& values, const MachineCounts& machine) {
  return std::ranges::all_of(
      values, [&](const auto& one) { return has_value(observation, one.first, one.second, machine); });
}

ObservationList selected(const ObservationList& from, const Selector& where, const MachineCounts& machine) {
  ObservationList list;
  for (const Observation* const one : from) {
    const bool fits = std::ranges::all_of(where, [&](const auto& allowed) {
      return std::ranges::any_of(allowed.second, [&](const std::string& value) {
        return has_value(*one, allowed.first, value, machine);
      });
    });
    if (fits) list.push_back(one);
  }
  return list;
}

std::vector<std::string> telling_factors(const ObservationList& list, const std::set<std::string>& named) {
  std::set<std::string> candidates = varying(list);
  for (const std::string& name : named) candidates.erase(name);
  std::vector<std::string> kept = by_preference(candidates);
  for (size_t i = kept.size(); i-- > 0;) {
    std::vector<std::string> others(named.begin(), named.end());
    for (const std::string& name : kept) {
      if (name != kept[i]) others.push_back(name);
    }
    if (is_decided(kept[i], others, list)) kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return kept;
}

std::vector<ObservationGroup> groups_by(const ObservationList& list,
                                        const std::vector<std::string>& factors) {
  std::vector<Factors> combinations;
  for (const Observation* const one : list) {
    Factors own;
    for (const std::string& name : factors) own[name] = value_of(*one, name);
    if (std::ranges::find(combinations, own) == combinations.end()) combinations.push_back(std::move(own));
  }
  const auto is_part_of = [](const Factors& part, const Factors& whole) {
    return part != whole && std::ranges::all_of(part, [&](const auto& one) {
             return one.second == no_use || whole.at(one.first) == one.second;
           });
  };
  std::vector<ObservationGroup> groups;
  for (const Factors& own : combinations) {
    if (std::ranges::any_of(combinations, [&](const Factors& other) { return is_part_of(own, other); }))
      continue;
    ObservationGroup& group = groups.emplace_back(ObservationGroup{own, {}});
    for (const Observation* const one : list) {
      if (has_values(*one, own, {})) group.members.push_back(one);
    }
  }
  return groups;
}

std::set<std::string> named_factors(const Claim& claim) {
  std::set<std::string> names;
  for (const Factors* const factors : {&claim.of, &claim.to}) {
    for (const auto& [name, value] : *factors) names.insert(name);
  }
  if (!claim.key.empty()) names.insert(claim.key);
  return names;
}

std::string to_text(const Factors& factors) {
  std::string text;
  for (const auto& [name, value] : factors)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, value);
  return text.empty() ? "all" : text;
}

}  // namespace raysweep
