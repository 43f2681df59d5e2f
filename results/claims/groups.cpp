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

bool has_no_use_for_some(const Factors& factors) {
  return std::ranges::any_of(factors, [](const auto& one) { return one.second == no_use; });
}

/// Whether they have the same values but for those that `part` has no use for.
bool is_part_of(const Factors& part, const Factors& whole) {
  return std::ranges::all_of(
      part, [&](const auto& one) { return one.second == no_use || whole.at(one.first) == one.second; });
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
  std::vector<ObservationGroup> groups;
  std::map<Factors, size_t> places;
  for (const Observation* const one : list) {
    Factors own;
    for (const std::string& name : factors) own[name] = value_of(*one, name);
    const auto [place, is_new] = places.emplace(own, groups.size());
    if (is_new) groups.push_back({std::move(own), {}});
    groups[place->second].members.push_back(one);
  }
  const std::vector<ObservationGroup> exact = groups;
  groups.clear();
  for (const ObservationGroup& whole : exact) {
    ObservationGroup group = whole;
    bool is_only_part = false;
    for (const ObservationGroup& part : exact) {
      if (&part == &whole) continue;
      is_only_part =
          is_only_part || (has_no_use_for_some(whole.factors) && is_part_of(whole.factors, part.factors));
      if (has_no_use_for_some(part.factors) && is_part_of(part.factors, whole.factors))
        group.members.insert(group.members.end(), part.members.begin(), part.members.end());
    }
    if (!is_only_part) groups.push_back(std::move(group));
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

std::string factor_text(const std::string& name, const std::string& value) {
  return fmt::format("{} {}{}", name, mentions_machine(value) ? "= " : "", value);
}

std::string to_text(const Factors& factors) {
  std::string text;
  for (const auto& [name, value] : factors)
    text.append(text.empty() ? "" : ", ").append(factor_text(name, value));
  return text.empty() ? "all" : text;
}

}  // namespace raysweep
