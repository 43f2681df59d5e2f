#include "results/claims/group_question.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "results/claims/rules.h"

namespace raysweep {

namespace {

/// Thrown where a question cannot be asked.
struct Problem {
  std::string text;
  bool is_absent;
};

/// A value: that of an observation, divided by another's if it is relative to it.
struct Term {
  size_t own;
  std::optional<size_t> base;
};

double value_of(const Term& term, const std::vector<double>& raw) {
  return term.base ? raw[term.own] / raw[*term.base] : raw[term.own];
}

std::vector<double> values_of(const std::vector<Term>& terms, const std::vector<double>& raw) {
  std::vector<double> values;
  for (const Term& term : terms) values.push_back(value_of(term, raw));
  return values;
}

/// The observations of one value of the key.
struct Keyed {
  std::string key;
  ObservationList found;
};

class Asker {
 public:
  Asker(const Claim& claim, const ObservationGroup& group, const Bases& bases, const MachineCounts& machine)
      : claim_(claim), group_(group), bases_(bases), machine_(machine) {}

  GroupQuestion ask() {
    switch (claim_.rule) {
      case Rule::ratio:
        ask_ratio();
        break;
      case Rule::argmax:
      case Rule::argmin:
        ask_best();
        break;
      case Rule::plateau:
        ask_plateau();
        break;
      case Rule::step:
        ask_step();
        break;
      case Rule::linear:
        ask_linear();
        break;
      case Rule::order:
        ask_order();
        break;
      case Rule::value:
        ask_value();
        break;
    }
    return std::move(question_);
  }

 private:
  size_t need(const Observation* one) {
    if (one->value.count == 0) throw Problem{fmt::format("{} was not measured", of(*one)), false};
    const auto found = std::ranges::find(question_.needed, one);
    if (found == question_.needed.end()) {
      question_.needed.push_back(one);
      return question_.needed.size() - 1;
    }
    return static_cast<size_t>(found - question_.needed.begin());
  }

  /// What sets it apart within the group.
  [[nodiscard]] std::string of(const Observation& one) const {
    Factors own;
    for (const std::string& name : named_factors(claim_)) {
      if (const auto found = one.factors.find(name); found != one.factors.end()) own.insert(*found);
    }
    return to_text(own);
  }

  Term term(const Observation* one) {
    if (claim_.relative_to.empty()) return {need(one), {}};
    for (const Observation* const base : bases_.list) {
      const bool fits =
          has_values(*base, claim_.relative_to, machine_) &&
          std::ranges::all_of(bases_.telling, [&](const std::string& name) {
            const auto own = one->factors.find(name);
            return own == one->factors.end() || own->second == "-" || has_value(*base, name, own->second, {});
          });
      if (fits) return {need(one), need(base)};
    }
    throw Problem{fmt::format("there is none at {} to relate {} to", to_text(claim_.relative_to), of(*one)),
                  true};
  }

  Term the_one(const Factors& factors) {
    ObservationList found;
    for (const Observation* const one : group_.members) {
      if (has_values(*one, factors, machine_)) found.push_back(one);
    }
    if (found.empty()) throw Problem{fmt::format("there is none at {}", to_text(factors)), true};
    refuse_several(found, to_text(factors));
    return term(found.front());
  }

  void refuse_several(const ObservationList& found, const std::string& what) const {
    if (found.size() == 1) return;
    const auto differing = telling_factors(found, {});
    throw Problem{fmt::format("{} numbers are at {}, which differ in {}: name that in where or for_each",
                              found.size(), what, fmt::join(differing, ", ")),
                  false};
  }

  /// By the key, in the order of its values.
  [[nodiscard]] std::vector<Keyed> by_key() const {
    std::map<std::string, ObservationList, decltype(&is_value_before)> found(&is_value_before);
    for (const Observation* const one : group_.members) {
      const auto own = one->factors.find(claim_.key);
      if (own != one->factors.end() && own->second != "-") found[own->second].push_back(one);
    }
    std::vector<Keyed> list;
    for (const auto& [key, observations] : found) list.push_back({key, observations});
    if (list.empty()) throw Problem{fmt::format("none has a {}", claim_.key), true};
    return list;
  }

  Term term(const Keyed& one) {
    refuse_several(one.found, fmt::format("{} {}", claim_.key, one.key));
    return term(one.found.front());
  }

  [[nodiscard]] bool is_key(const std::string& key, const std::string& value) const {
    Observation probe;
    probe.factors[claim_.key] = key;
    return has_value(probe, claim_.key, value, machine_);
  }

  [[nodiscard]] bool is_in(const std::string& key, const std::vector<std::string>& values) const {
    return std::ranges::any_of(values, [&](const std::string& value) { return is_key(key, value); });
  }

  void ask_ratio() {
    const Term of = the_one(claim_.of), to = the_one(claim_.to);
    question_.statistic = [of, to](const std::vector<double>& raw) {
      return value_of(of, raw) / value_of(to, raw);
    };
  }

  void ask_value() {
    const Term of = the_one({});
    question_.statistic = [of](const std::vector<double>& raw) { return value_of(of, raw); };
  }

  void ask_best() {
    std::vector<Term> expected, others;
    for (const Keyed& one : by_key())
      (is_in(one.key, claim_.expected_values) ? expected : others).push_back(term(one));
    const std::string wanted = fmt::format("{} {}", claim_.key, fmt::join(claim_.expected_values, ", "));
    if (expected.empty()) throw Problem{fmt::format("there is none at {}", wanted), true};
    if (others.empty()) throw Problem{fmt::format("there is none but at {}", wanted), true};
    const auto rule = claim_.rule == Rule::argmax ? largest_against : smallest_against;
    question_.statistic = [=](const std::vector<double>& raw) {
      return rule(values_of(expected, raw), values_of(others, raw));
    };
  }

  /// The values that `over` or `values` allow.
  [[nodiscard]] std::vector<Keyed> in_range(size_t fewest) const {
    std::vector<Keyed> list;
    for (const Keyed& one : by_key()) {
      if (!claim_.over.empty()) {
        const double low = evaluate(claim_.over[0], machine_), high = evaluate(claim_.over[1], machine_);
        const auto number = leading_number(one.key);
        if (!number || *number < low || *number > high) continue;
      }
      if (claim_.values.empty() || is_in(one.key, claim_.values)) list.push_back(one);
    }
    if (list.size() < fewest)
      throw Problem{
          fmt::format("{} values of {} are there, where {} are needed", list.size(), claim_.key, fewest),
          true};
    return list;
  }

  void ask_plateau() {
    std::vector<Term> terms;
    for (const Keyed& one : in_range(2)) terms.push_back(term(one));
    question_.statistic = [=](const std::vector<double>& raw) { return spread(values_of(terms, raw)); };
  }

  void ask_linear() {
    std::vector<Term> terms;
    std::vector<double> x;
    for (const Keyed& one : in_range(claim_.intercept ? 3 : 2)) {
      const auto number = leading_number(one.key);
      if (!number) throw Problem{fmt::format("{} {} is no number", claim_.key, one.key), false};
      terms.push_back(term(one));
      x.push_back(*number);
    }
    question_.statistic = [terms, x, inverse = claim_.inverse,
                           intercept = claim_.intercept](const std::vector<double>& raw) {
      std::vector<double> y = values_of(terms, raw);
      for (double& value : y) value = inverse ? 1 / value : value;
      return largest_residual(x, y, intercept);
    };
  }

  [[nodiscard]] std::vector<Keyed>::const_iterator place_of(const std::vector<Keyed>& list,
                                                            const std::string& value) const {
    const auto found = std::ranges::find_if(list, [&](const auto& one) { return is_key(one.key, value); });
    if (found == list.end()) throw Problem{fmt::format("there is none at {} {}", claim_.key, value), true};
    return found;
  }

  void ask_step() {
    const std::vector<Keyed> list = by_key();
    const auto at = place_of(list, claim_.at);
    if (claim_.from.empty() && at == list.begin())
      throw Problem{fmt::format("there is none before {} {}", claim_.key, claim_.at), true};
    const auto from = claim_.from.empty() ? at - 1 : place_of(list, claim_.from);
    const Term of = term(*at), to = term(*from);
    question_.statistic = [of, to](const std::vector<double>& raw) {
      return value_of(of, raw) / value_of(to, raw);
    };
  }

  void ask_order() {
    const std::vector<Keyed> list = by_key();
    std::vector<Term> ordered;
    for (const std::string& value : claim_.expected_values) ordered.push_back(term(*place_of(list, value)));
    question_.statistic = [ordered, first = claim_.smallest_first](const std::vector<double>& raw) {
      return least_neighbour_ratio(values_of(ordered, raw), first);
    };
  }

  const Claim& claim_;
  const ObservationGroup& group_;
  const Bases& bases_;
  const MachineCounts machine_;
  GroupQuestion question_;
};

}  // namespace

Bases bases_of(const Claim& claim, ObservationList all) {
  std::set<std::string> named;
  for (const auto& [name, value] : claim.relative_to) named.insert(name);
  std::vector<std::string> telling;
  if (!named.empty()) telling = telling_factors(all, named);
  return {std::move(all), std::move(telling)};
}

GroupQuestion ask(const Claim& claim, const ObservationGroup& group, const Bases& bases,
                  const MachineCounts& machine) {
  try {
    return Asker(claim, group, bases, machine).ask();
  } catch (const Problem& problem) {
    return {{}, {}, problem.is_absent, problem.text};
  } catch (const ExpressionError& error) {
    return {{}, {}, false, error.what()};
  }
}

}  // namespace raysweep
