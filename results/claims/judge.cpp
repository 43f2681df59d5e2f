#include "results/claims/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "results/claims/claim_text.h"
#include "results/claims/group_estimate.h"

namespace raysweep {

namespace {

/// What a rule expects where a claim says nothing else.
ExpectedRange usual_range(const Claim& claim) {
  switch (claim.rule) {
    case Rule::argmax:
    case Rule::argmin:
    case Rule::order:
      return {fmt::format("{}", 1 - claim.within), "", false, false};
    case Rule::plateau:
      return {"", "1.05", false, false};
    case Rule::linear:
      return {"", "0.1", false, false};
    case Rule::ratio:
    case Rule::step:
    case Rule::value:
      break;
  }
  return {};
}

/// None where the claim expects something of other groups only.
std::optional<ExpectedRange> range_for(const Claim& claim, const Factors& group) {
  if (claim.expect.empty()) return usual_range(claim);
  if (const auto found = claim.expect.find(""); found != claim.expect.end()) return found->second;
  for (const auto& [name, value] : group) {
    if (const auto found = claim.expect.find(value); found != claim.expect.end()) return found->second;
  }
  return std::nullopt;
}

/// Whether all of the interval is inside, or all of it outside; none where it has parts of both.
std::optional<bool> is_inside(const Estimate::Bounds& interval, const GroupJudgement& made) {
  const auto below = [&](double value) {
    return made.low && (made.low_open ? value <= *made.low : value < *made.low);
  };
  const auto above = [&](double value) {
    return made.high && (made.high_open ? value >= *made.high : value > *made.high);
  };
  if (!below(interval.low) && !above(interval.high)) return true;
  if (below(interval.high) || above(interval.low)) return false;
  return std::nullopt;
}

void judge_group(GroupJudgement& made, const GroupQuestion& question, const ExpectedRange& range,
                 const MachineCounts& machine) {
  const Estimate number = estimate(question);
  if (std::isnan(number.value)) {
    made.problem = "its values come to no number";
    return;
  }
  made.value = number.value;
  made.interval = number.interval;
  made.low_open = range.low_open;
  made.high_open = range.high_open;
  try {
    if (!range.low.empty()) made.low = evaluate(range.low, machine);
    if (!range.high.empty()) made.high = evaluate(range.high, machine);
  } catch (const ExpressionError& error) {
    made.problem = error.what();
    return;
  }
  if (!made.interval) {
    made.problem = "fewer than 6 rounds: no interval";
    return;
  }
  made.holds = is_inside(*made.interval, made);
  if (!made.holds) made.problem = "its interval reaches across the edge of what is expected";
}

/// In how many of `count` groups the claim must hold.
size_t needed_groups(const Claim& claim, size_t count) {
  if (claim.holds == "any") return 1;
  if (claim.holds == "most") return count / 2 + 1;
  const double share = leading_number(claim.holds).value_or(1);  // "all"
  return static_cast<size_t>(std::ceil(share * static_cast<double>(count) - 1e-9));
}

void add_verdict(SideJudgement& side, const Claim& claim) {
  const auto count = [&](std::optional<bool> holds) {
    return static_cast<size_t>(
        std::ranges::count_if(side.groups, [&](const auto& group) { return group.holds == holds; }));
  };
  const size_t yes = count(true), open = count(std::nullopt), all = side.groups.size();
  const size_t needed = needed_groups(claim, all);
  const bool any_told =
      std::ranges::any_of(side.groups, [](const auto& group) { return group.value.has_value(); });
  side.sentence = found_text(side.groups);
  if (all > 1 && any_told) side.sentence += fmt::format("; holds in {} of {}", yes, all);
  if (yes >= needed) {
    side.verdict = ClaimVerdict::holds;
  } else if (yes + open < needed) {
    side.verdict = ClaimVerdict::fails;
  } else {
    const auto first = std::ranges::find_if(side.groups, [](const auto& group) { return !group.holds; });
    side.is_undecided = first->value.has_value();
    if (any_told) side.sentence += fmt::format("; undecided: {}", first->problem);
  }
}

SideJudgement untold(std::string sentence) { return {ClaimVerdict::untold, false, std::move(sentence), {}}; }

/// Whether the claim is about this machine; else why not.
std::optional<std::string> why_not_applicable(const Claim& claim, const MachineCounts& machine) {
  if (claim.applies_when.empty()) return std::nullopt;
  try {
    if (evaluate(claim.applies_when, machine) != 0) return std::nullopt;
  } catch (const ExpressionError& error) {
    return error.what();
  }
  return fmt::format("needs {}, where there are {} cores and {} processors", claim.applies_when,
                     machine.cores, machine.pus);
}

SideJudgement judge_published(const Claim& claim, const ClaimSheet& sheet) {
  if (claim.applies_to == AppliesTo::neither) return untold("no printed number tells it");
  if (claim.applies_to == AppliesTo::ours) return untold("a claim about our numbers only");
  if (!sheet.published) return untold("there is no printed table");
  const auto printed = observations_of(*sheet.published, claim.quantity);
  if (!printed)
    return untold(fmt::format("the table prints {}, not {}", sheet.published->quantity, claim.quantity));
  return judge(claim, *printed, sheet.published->machine);
}

SideJudgement judge_ours(const Claim& claim, const Observations& ours, const MachineCounts& machine) {
  if (claim.applies_to == AppliesTo::neither) return untold("no record tells it");
  if (claim.applies_to == AppliesTo::published) return untold("a claim about the printed numbers only");
  const auto found = ours.find(claim.quantity);
  if (found == ours.end()) return untold(fmt::format("nothing was measured of {}", claim.quantity));
  return judge(claim, found->second, machine);
}

}  // namespace

std::string ClaimJudgement::published_verdict() const {
  switch (published.verdict) {
    case ClaimVerdict::holds:
      return "holds in the source";
    case ClaimVerdict::fails:
      return "contradicted by its own table";
    case ClaimVerdict::untold:
      break;
  }
  return published.is_undecided ? "undecided by its digits" : "not in a table";
}

std::string ClaimJudgement::our_verdict() const {
  switch (ours.verdict) {
    case ClaimVerdict::holds:
      return "reproduced";
    case ClaimVerdict::fails:
      return "not reproduced";
    case ClaimVerdict::untold:
      break;
  }
  return "cannot be tested here";
}

SideJudgement judge(const Claim& claim, const std::vector<Observation>& observations,
                    const MachineCounts& machine) {
  if (const auto reason = why_not_applicable(claim, machine)) return untold(*reason);
  ObservationList all;
  for (const Observation& one : observations) all.push_back(&one);
  const ObservationList chosen = selected(all, claim.where, machine);
  const auto names = claim.has_for_each ? claim.for_each : telling_factors(chosen, named_factors(claim));
  const Bases bases = bases_of(claim, std::move(all));
  SideJudgement side;
  std::string absent = "no such numbers";
  for (const ObservationGroup& group : groups_by(chosen, names)) {
    const auto range = range_for(claim, group.factors);
    if (!range) continue;
    const GroupQuestion question = ask(claim, group, bases, machine);
    if (question.is_absent) {
      absent = question.problem;
      continue;
    }
    GroupJudgement& made = side.groups.emplace_back();
    made.group = group.factors;
    made.problem = question.problem;
    if (question.problem.empty()) judge_group(made, question, *range, machine);
  }
  if (side.groups.empty()) return untold(absent);
  add_verdict(side, claim);
  return side;
}

std::vector<ClaimJudgement> judge_all(const ClaimSheet& sheet, const Observations& ours,
                                      const MachineCounts& machine) {
  std::vector<ClaimJudgement> list;
  for (const Claim& claim : sheet.claims)
    list.push_back({claim, judge_published(claim, sheet), judge_ours(claim, ours, machine)});
  return list;
}

}  // namespace raysweep
