#include "results/claims/claim_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "results/record.h"

namespace raysweep {

namespace {

using nlohmann::json;

/// The fields that are written as they are, named once for both directions; defaults are not written.
template <class Each>
void for_each_claim_field(Each&& each) {
  using C = Claim;
  each("id", &C::id), each("text", &C::text), each("source", &C::source), each("quantity", &C::quantity);
  each("where", &C::where), each("for_each", &C::for_each), each("relative_to", &C::relative_to);
  each("of", &C::of), each("to", &C::to), each("key", &C::key), each("expected_values", &C::expected_values);
  each("over", &C::over), each("values", &C::values), each("at", &C::at), each("from", &C::from);
  each("inverse", &C::inverse), each("intercept", &C::intercept);
  each("smallest_first", &C::smallest_first), each("within", &C::within), each("holds", &C::holds);
  each("applies_when", &C::applies_when), each("why", &C::why);
}

template <size_t count>
size_t place_of(const std::array<std::string_view, count>& names, const std::string& name) {
  const auto found = std::ranges::find(names, name);
  if (found == names.end())
    throw RecordError(fmt::format("unknown \"{}\" in a claim; possible: {}", name, fmt::join(names, ", ")));
  return static_cast<size_t>(found - names.begin());
}

json to_json(const ExpectedRange& range) {
  return {
      {"low", range.low}, {"high", range.high}, {"low_open", range.low_open}, {"high_open", range.high_open}};
}

json to_json(const Claim& claim) {
  static const Claim usual;
  json made{{"rule", name_of(claim.rule)}};
  for_each_claim_field([&](const char* name, auto field) {
    if (claim.*field != usual.*field) made[name] = claim.*field;
  });
  if (claim.has_for_each) made["for_each"] = claim.for_each;
  for (const auto& [group, range] : claim.expect) made["expect"][group] = to_json(range);
  if (claim.applies_to != AppliesTo::both)
    made["applies_to"] = applies_to_names[static_cast<size_t>(claim.applies_to)];
  return made;
}

Claim claim_of(const json& from) {
  Claim claim;
  for_each_claim_field([&](const char* name, auto field) {
    if (from.contains(name)) from.at(name).get_to(claim.*field);
  });
  claim.rule = static_cast<Rule>(place_of(rule_names, from.at("rule")));
  claim.applies_to = static_cast<AppliesTo>(place_of(applies_to_names, from.value("applies_to", "both")));
  claim.has_for_each = from.contains("for_each");
  if (from.contains("expect")) {
    for (const auto& [group, range] : from.at("expect").items())
      claim.expect[group] = {range.at("low"), range.at("high"), range.at("low_open"), range.at("high_open")};
  }
  return claim;
}

json to_json(const PublishedTable& table) {
  json made{{"file", table.file},
            {"quantity", table.quantity},
            {"scale", table.scale},
            {"rows_are", table.rows},
            {"normalise", table.normalise},
            {"machine", {{"cores", table.machine.cores}, {"pus", table.machine.pus}}},
            {"rows", json::array()}};
  for (const PrintedNumber& number : table.numbers)
    made["rows"].push_back({{"factors", number.factors}, {"printed", number.text}});
  return made;
}

PublishedTable published_of(const json& from) {
  PublishedTable table;
  from.at("file").get_to(table.file);
  from.at("quantity").get_to(table.quantity);
  from.at("scale").get_to(table.scale);
  from.at("rows_are").get_to(table.rows);
  from.at("normalise").get_to(table.normalise);
  table.machine = {from.at("machine").at("cores"), from.at("machine").at("pus")};
  for (const auto& row : from.at("rows")) table.numbers.push_back({row.at("factors"), row.at("printed")});
  return table;
}

}  // namespace

void add_to_plan(json& plan, const ClaimSheet& sheet) {
  if (!sheet.question.empty()) plan["question"] = sheet.question;
  if (!sheet.command.empty()) plan["command"] = sheet.command;
  for (const Claim& claim : sheet.claims) plan["claims"].push_back(to_json(claim));
  if (sheet.published) plan["published"] = to_json(*sheet.published);
}

ClaimSheet claim_sheet_of(const json& plan) {
  ClaimSheet sheet;
  sheet.question = plan.value("question", "");
  sheet.command = plan.value("command", "");
  if (plan.contains("claims")) {
    for (const auto& one : plan.at("claims")) sheet.claims.push_back(claim_of(one));
  }
  if (plan.contains("published")) sheet.published = published_of(plan.at("published"));
  return sheet;
}

}  // namespace raysweep
