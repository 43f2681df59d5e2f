#include "results/claims/published_rows.h"

#include <algorithm>
#include <set>

#include "results/claims/group_estimate.h"

namespace raysweep {

namespace {

/// Of ours those that are of a printed number.
ObservationList matches(const ObservationList& ours, const Factors& printed) {
  ObservationList list;
  for (const Observation* const one : ours) {
    const bool has_all = std::ranges::all_of(printed, [&](const auto& factor) {
      return one->factors.contains(factor.first) && has_value(*one, factor.first, factor.second, {});
    });
    if (has_all) list.push_back(one);
  }
  return list;
}

/// Ours that are of any printed number, by what the table does not tell of them.
std::vector<ObservationGroup> variants_of(const PublishedTable& table, const std::vector<Observation>& ours) {
  ObservationList all, of_table;
  for (const Observation& one : ours) all.push_back(&one);
  std::set<const Observation*> found;
  std::set<std::string> named;
  for (const PrintedNumber& number : table.numbers) {
    for (const auto& [name, value] : number.factors) named.insert(name);
    for (const Observation* const one : matches(all, number.factors)) {
      if (found.insert(one).second) of_table.push_back(one);
    }
  }
  if (of_table.empty()) return {ObservationGroup()};
  return groups_by(of_table, telling_factors(of_table, named));
}

/// None where there is none, or it was not measured.
const Observation* ours_of(const ObservationGroup& variant, const Factors& printed) {
  const ObservationList found = matches(variant.members, printed);
  return found.empty() || found.front()->value.count == 0 ? nullptr : found.front();
}

/// The first line of the same column.
const PrintedNumber& first_of_column(const PublishedTable& table, const PrintedNumber& number) {
  const auto column = [&](const PrintedNumber& one) {
    Factors factors = one.factors;
    for (const std::string& name : table.rows) factors.erase(name);
    return factors;
  };
  const Factors own = column(number);
  return *std::ranges::find_if(table.numbers, [&](const auto& other) { return column(other) == own; });
}

Estimate ratio_of(const Observation& of, const Observation& to) {
  GroupQuestion question;
  question.needed = {&of, &to};
  question.statistic = [](const std::vector<double>& values) { return values[0] / values[1]; };
  return estimate(question);
}

}  // namespace

std::vector<PublishedRow> published_rows(const PublishedTable& table, const std::vector<Observation>& ours) {
  std::vector<PublishedRow> rows;
  for (const ObservationGroup& variant : variants_of(table, ours)) {
    for (const PrintedNumber& number : table.numbers) {
      PublishedRow& row = rows.emplace_back();
      row.factors = variant.factors;
      for (const auto& [name, value] : number.factors) row.factors[name] = value;
      row.printed = number.text;
      const Observation* const own = ours_of(variant, number.factors);
      if (own) row.ours = own->value;
      if (table.normalise != "first_row") continue;
      const PrintedNumber& first = first_of_column(table, number);
      row.printed_normalised = *leading_number(number.text) / *leading_number(first.text);
      const Observation* const base = ours_of(variant, first.factors);
      if (own && base) row.ours_normalised = ratio_of(*own, *base);
    }
  }
  return rows;
}

}  // namespace raysweep
