#include "results/tables/claims_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "results/claims/claim_text.h"
#include "results/claims/groups.h"
#include "results/tables/number_text.h"

namespace raysweep {

namespace {

std::string truth_text(const std::optional<bool>& value) { return !value ? "" : *value ? "yes" : "no"; }

void add_groups(Table& table, const ClaimJudgement& judged, const char* side_name, const SideJudgement& side,
                const std::string& verdict) {
  const auto add = [&](const GroupJudgement& group) {
    const auto bound = [&](bool low) {
      return group.interval ? fmt::format("{}", low ? group.interval->low : group.interval->high)
                            : std::string();
    };
    table.rows.push_back({judged.claim.id, side_name, verdict,
                          group.group.empty() ? "" : to_text(group.group), unrounded(group.value),
                          bound(true), bound(false), unrounded(group.low), unrounded(group.high),
                          truth_text(group.holds), group.problem});
  };
  if (side.groups.empty()) {
    GroupJudgement none;
    none.problem = side.sentence;
    add(none);
  }
  for (const GroupJudgement& group : side.groups) add(group);
}

/// Of all rows, in their order.
std::set<std::string> names_of(const std::vector<PublishedRow>& rows) {
  std::set<std::string> names;
  for (const PublishedRow& row : rows) {
    for (const auto& [name, value] : row.factors) names.insert(name);
  }
  return names;
}

std::string value_of(const PublishedRow& row, const std::string& name) {
  const auto found = row.factors.find(name);
  return found == row.factors.end() ? "-" : found->second;
}

bool varies(const std::vector<PublishedRow>& rows, const std::string& name) {
  return std::ranges::any_of(
      rows, [&](const PublishedRow& row) { return value_of(row, name) != value_of(rows.front(), name); });
}

bool are_numbers(const std::vector<PublishedRow>& rows, const std::string& name) {
  return std::ranges::all_of(
      rows, [&](const PublishedRow& row) { return leading_number(value_of(row, name)).has_value(); });
}

}  // namespace

Table claims_table(const std::vector<ClaimJudgement>& claims) {
  Table table;
  table.caption =
      "Claims: what the source's own numbers say, and what ours do\n"
      "brackets hold 95 % intervals of ours, and what the last printed digits leave open";
  for (const char* title :
       {"claim", "says", "asks", "in the source", "found there", "here", "found here", "why"})
    table.columns.push_back({title, false});
  for (const ClaimJudgement& one : claims) {
    const Claim& claim = one.claim;
    table.rows.push_back({claim.id, claim.text, rule_sentence(claim), one.published_verdict(),
                          one.published.sentence, one.our_verdict(), one.ours.sentence, claim.why});
  }
  return table;
}

Table claims_data(const std::vector<ClaimJudgement>& claims) {
  Table table;
  for (const char* title : {"claim", "side", "verdict", "group"}) table.columns.push_back({title, false});
  for (const char* title : {"value", "low", "high", "expected_low", "expected_high"})
    table.columns.push_back({title});
  for (const char* title : {"holds", "problem"}) table.columns.push_back({title, false});
  for (const ClaimJudgement& one : claims) {
    add_groups(table, one, "source", one.published, one.published_verdict());
    add_groups(table, one, "here", one.ours, one.our_verdict());
  }
  return table;
}

Table published_table(const PublishedTable& published, const std::vector<PublishedRow>& rows) {
  const bool is_normalised = published.normalise == "first_row";
  Table table;
  table.caption = fmt::format("{} of {} beside ours", published.quantity, published.file);
  if (is_normalised) table.caption += ", and each column by its first line, since machines differ";
  std::vector<std::string> names;
  std::string constant;
  for (const std::string& name : names_of(rows)) {
    if (varies(rows, name)) {
      names.push_back(name);
      table.columns.push_back({name, are_numbers(rows, name)});
    } else {
      constant += fmt::format("{}{} {}", constant.empty() ? "\n" : " · ", name, value_of(rows.front(), name));
    }
  }
  table.caption += constant;
  table.columns.insert(table.columns.end(), {{"printed"}, {"ours"}});
  if (is_normalised)
    table.columns.insert(table.columns.end(), {{"printed, normalised"}, {"ours, normalised"}});
  for (const PublishedRow& row : rows) {
    auto& cells = table.rows.emplace_back();
    for (const std::string& name : names) cells.push_back(value_of(row, name));
    cells.insert(cells.end(), {row.printed, with_interval(row.ours)});
    if (!is_normalised) continue;
    cells.push_back(row.printed_normalised ? significant(*row.printed_normalised) : "–");
    cells.push_back(with_interval(row.ours_normalised));
  }
  return table;
}

Table published_data(const std::vector<PublishedRow>& rows) {
  Table table;
  const auto names = names_of(rows);
  for (const std::string& name : names) table.columns.push_back({name, are_numbers(rows, name)});
  for (const char* title : {"printed", "printed_normalised", "ours", "ours_low", "ours_high",
                            "ours_normalised", "ours_normalised_low", "ours_normalised_high"})
    table.columns.push_back({title});
  for (const PublishedRow& row : rows) {
    auto& cells = table.rows.emplace_back();
    for (const std::string& name : names) cells.push_back(value_of(row, name));
    cells.insert(cells.end(), {row.printed, unrounded(row.printed_normalised)});
    for (const auto& estimate : {row.ours, row.ours_normalised}) {
      for (std::string& number : unrounded(estimate)) cells.push_back(std::move(number));
    }
  }
  return table;
}

std::string claims_as_text(const std::vector<ClaimJudgement>& claims) {
  std::string text;
  for (const ClaimJudgement& one : claims) {
    text +=
        fmt::format("{}{}: {}\n  asked: {}\n  in the source: {}: {}\n  here: {}: {}\n",
                    text.empty() ? "" : "\n", one.claim.id, one.claim.text, rule_sentence(one.claim),
                    one.published_verdict(), one.published.sentence, one.our_verdict(), one.ours.sentence);
    if (!one.claim.why.empty() && one.our_verdict() != "reproduced")
      text += fmt::format("  why: {}\n", one.claim.why);
  }
  return text;
}

}  // namespace raysweep
