#include "results/claims/claim_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "results/claims/groups.h"

namespace raysweep {

namespace {

constexpr size_t most_groups_told = 6;

/// As tables print numbers, but for small ones: 1.2e-07.
std::string number_text(double value) { return fmt::format("{:.4g}", value); }

std::string range_text(const std::string& low, const std::string& high, bool low_open, bool high_open) {
  if (!low.empty() && low == high) return low;
  if (!low.empty() && !high.empty()) return fmt::format("{} to {}", low, high);
  if (!low.empty()) return fmt::format("{} {}", low_open ? "above" : "at least", low);
  if (!high.empty()) return fmt::format("{} {}", high_open ? "below" : "at most", high);
  return "any";
}

std::string expectation(const Claim& claim) {
  std::string text;
  for (const auto& [group, range] : claim.expect) {
    text += fmt::format("{}{}{}", text.empty() ? "" : ", ", group.empty() ? "" : group + " ",
                        range_text(range.low, range.high, range.low_open, range.high_open));
  }
  if (!text.empty()) return text;
  if (claim.rule == Rule::plateau) return "at most 1.05";
  if (claim.rule == Rule::linear) return "at most 0.1";
  return fmt::format("at least {:.4g}", 1 - claim.within);
}

std::string range_of_key(const Claim& claim) {
  if (!claim.values.empty()) return fmt::format("{} {}", claim.key, fmt::join(claim.values, ", "));
  if (!claim.over.empty()) return fmt::format("{} {} to {}", claim.key, claim.over[0], claim.over[1]);
  return "all " + claim.key;
}

std::string compared(const Claim& claim) {
  const std::string& quantity = claim.quantity;
  const std::string expected = fmt::format("{}", fmt::join(claim.expected_values, ", "));
  switch (claim.rule) {
    case Rule::ratio:
      return fmt::format("{} at {} by that at {}", quantity, to_text(claim.of), to_text(claim.to));
    case Rule::argmax:
      return fmt::format("the largest {} at {} by the largest at any other", quantity,
                         factor_text(claim.key, expected));
    case Rule::argmin:
      return fmt::format("the smallest {} at any other {} by the smallest at {}", quantity, claim.key,
                         factor_text(claim.key, expected));
    case Rule::plateau:
      return fmt::format("the largest {} by the smallest over {}", quantity, range_of_key(claim));
    case Rule::step:
      return fmt::format("{} at {} by that at {}", quantity, factor_text(claim.key, claim.at),
                         claim.from.empty() ? "the value before" : factor_text(claim.key, claim.from));
    case Rule::linear:
      return fmt::format("the largest residual of {}{} against a line{} over {}, as a share",
                         claim.inverse ? "1/" : "", quantity, claim.intercept ? "" : " through the origin",
                         range_of_key(claim));
    case Rule::order:
      return fmt::format("the smallest ratio of neighbours in {} by {}, {} first: {}", quantity, claim.key,
                         claim.smallest_first ? "smallest" : "largest", expected);
    case Rule::value:
      return quantity;
  }
  return quantity;
}

std::string where_text(const Claim& claim) {
  std::string text;
  for (const auto& [name, values] : claim.where)
    text += fmt::format("{}{} {}", text.empty() ? "; where " : ", ", name, fmt::join(values, " or "));
  return text;
}

/// The largest and the smallest, and how many there are between.
std::string extremes(const std::vector<const GroupJudgement*>& told) {
  const auto by_value = [](const GroupJudgement* a, const GroupJudgement* b) {
    return *a->value < *b->value;
  };
  const auto [low, high] = std::ranges::minmax_element(told, by_value);
  return fmt::format("from {} to {}, {} groups", to_text(**low), to_text(**high), told.size());
}

}  // namespace

std::string rule_sentence(const Claim& claim) {
  std::string text = compared(claim);
  if (!claim.relative_to.empty()) text += fmt::format(", each relative to {}", to_text(claim.relative_to));
  text += where_text(claim);
  if (!claim.for_each.empty()) text += fmt::format("; for each {}", fmt::join(claim.for_each, ", "));
  text += fmt::format(": expected {}", expectation(claim));
  if (claim.holds != "all") {
    text += leading_number(claim.holds)
                ? fmt::format(", in {:.3g} % of the groups", 100 * *leading_number(claim.holds))
                : fmt::format(", in {} of the groups", claim.holds);
  }
  return text;
}

std::string to_text(const GroupJudgement& group) {
  const std::string of = group.group.empty() ? "" : fmt::format(" ({})", to_text(group.group));
  if (!group.value) return group.problem + of;
  const bool is_exact = group.interval && group.interval->low == group.interval->high;
  if (!group.interval || is_exact) return number_text(*group.value) + of;
  return fmt::format("{} [{}, {}]{}", number_text(*group.value), number_text(group.interval->low),
                     number_text(group.interval->high), of);
}

std::string expected_text(const GroupJudgement& group) {
  const auto text = [](const std::optional<double>& bound) {
    return bound ? number_text(*bound) : std::string();
  };
  return range_text(text(group.low), text(group.high), group.low_open, group.high_open);
}

std::string found_text(const std::vector<GroupJudgement>& groups) {
  std::vector<const GroupJudgement*> told;
  for (const GroupJudgement& group : groups) {
    if (group.value) told.push_back(&group);
  }
  if (told.empty()) return groups.front().problem;
  if (told.size() > most_groups_told) return extremes(told);
  std::string text;
  for (const GroupJudgement* const group : told)
    text.append(text.empty() ? "" : ", ").append(to_text(*group));
  return text;
}

}  // namespace raysweep
