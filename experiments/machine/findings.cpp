#include "experiments/machine/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "experiments/machine/finding_checks.h"

namespace raysweep {

namespace {

constexpr std::array<Check, 19> checks{
    check_noise,      check_quota,        check_throttling,     check_allowed,
    check_other_load, check_load_average, check_steal,          check_pressure,
    check_smt,        check_turbo,        check_governor,       check_frequency,
    check_clock,      check_memory,       check_swap,           check_huge_pages,
    check_layout,     check_build,        check_virtual_machine};

const char* name_of(FindingState state) {
  switch (state) {
    case FindingState::bad:
      return "bad";
    case FindingState::unknown:
      return "unknown";
    case FindingState::good:
      return "good";
  }
  return "";
}

}  // namespace

std::vector<Finding> judge(const Examination& examination) {
  std::vector<Finding> findings;
  for (const Check check : checks) findings.push_back(check(examination));
  std::stable_sort(findings.begin(), findings.end(),
                   [](const Finding& a, const Finding& b) { return a.state < b.state; });
  return findings;
}

std::string verdict(const std::vector<Finding>& findings) {
  std::string names;
  int bad_count = 0, unknown_count = 0;
  for (const Finding& finding : findings) {
    unknown_count += finding.state == FindingState::unknown;
    if (finding.state != FindingState::bad) continue;
    names += (bad_count++ == 0 ? "" : ", ") + finding.name;
  }
  if (bad_count > 0) {
    return fmt::format("{} to mend before you trust small differences: {}.",
                       bad_count == 1 ? "1 thing" : fmt::format("{} things", bad_count), names);
  }
  if (unknown_count == 0) return "Nothing found that would hide small differences.";
  return fmt::format("Nothing found that would hide small differences; {} cannot be known here.",
                     unknown_count == 1 ? "1 thing" : fmt::format("{} things", unknown_count));
}

Table table_of(const std::vector<Finding>& findings) {
  Table table;
  for (const char* title : {"state", "check", "found", "why it matters"})
    table.columns.push_back({title, false});
  for (const Finding& f : findings) table.rows.push_back({name_of(f.state), f.name, f.value, f.why});
  return table;
}

nlohmann::json to_json(const Finding& f) {
  return {{"name", f.name},
          {"state", name_of(f.state)},
          {"value", f.value},
          {"why", f.why},
          {"advice", f.advice}};
}

}  // namespace raysweep
