#include "experiments/claim_parser.h"

#include <fmt/format.h>

#include <algorithm>

namespace raysweep {

namespace {

/// What each rule asks for, beside what all claims may say.
std::vector<std::string_view> keys_of(Rule rule) {
  std::vector<std::string_view> keys{"id",           "text",       "source", "rule",        "quantity",
                                     "where",        "for_each",   "expect", "relative_to", "holds",
                                     "applies_when", "applies_to", "why"};
  const auto add = [&](std::initializer_list<std::string_view> more) {
    keys.insert(keys.end(), more.begin(), more.end());
  };
  switch (rule) {
    case Rule::ratio:
      add({"of", "to"});
      break;
    case Rule::argmax:
    case Rule::argmin:
      add({"key", "within"});
      break;
    case Rule::plateau:
      add({"key", "over", "values"});
      break;
    case Rule::step:
      add({"key", "at", "from"});
      break;
    case Rule::linear:
      add({"key", "over", "values", "of", "intercept"});
      break;
    case Rule::order:
      add({"key", "smallest_first", "within"});
      break;
    case Rule::value:
      break;
  }
  return keys;
}

bool expects_values(Rule rule) { return rule == Rule::argmax || rule == Rule::argmin || rule == Rule::order; }

}  // namespace

Claim ClaimParser::read(const toml::table& from) {
  from_ = &from;
  Claim claim;
  const std::string rule = reader_.text_or(from, "rule", "");
  const auto known = std::ranges::find(rule_names, rule);
  if (known == rule_names.end()) {
    fail("rule", fmt::format("unknown rule \"{}\"; possible: {}", rule, fmt::join(rule_names, ", ")));
    return claim;
  }
  claim.rule = static_cast<Rule>(known - rule_names.begin());
  reader_.check_keys(from, "claim.", keys_of(claim.rule));
  read_texts(claim);
  read_choice(claim);
  read_conditions(claim);
  if (claim.rule == Rule::ratio) {
    read_ratio(claim);
  } else if (claim.rule != Rule::value) {
    read_key(claim);
  }
  read_expectation(claim);
  return claim;
}

/// At the key, or at the claim where it is missing.
void ClaimParser::fail(const char* key, const std::string& sentence) {
  const toml::node* const node = from_->get(key);
  reader_.fail(node ? *node : *from_, sentence);
}

std::string ClaimParser::text(const char* key, const std::string& otherwise) {
  return reader_.text_or(*from_, key, otherwise);
}

void ClaimParser::read_texts(Claim& claim) {
  claim.id = text("id");
  claim.text = text("text");
  claim.source = text("source");
  claim.why = text("why");
  if (claim.id.empty()) fail("id", "a claim needs an id, which is its name in tables: id = \"peak-at-pus\"");
  if (claim.text.empty()) fail("text", "a claim needs a text, which says in words what is claimed");
  if (!claim.id.empty() && !ids_.insert(claim.id).second)
    fail("id", fmt::format("claim \"{}\" is there twice; each needs an id of its own", claim.id));
  claim.quantity = text("quantity", scope_.quantities.front());
  if (std::ranges::find(scope_.quantities, claim.quantity) == scope_.quantities.end()) {
    fail("quantity", fmt::format("unknown quantity \"{}\"; possible: {}", claim.quantity,
                                 fmt::join(scope_.quantities, ", ")));
  }
}

void ClaimParser::read_choice(Claim& claim) {
  if (const auto* const where = from_->get("where")) claim.where = values_.selector(*where, "claim.where");
  if (const auto* const base = from_->get("relative_to"))
    claim.relative_to = values_.factors(*base, "claim.relative_to");
  const toml::node* const for_each = from_->get("for_each");
  if (!for_each) return;
  claim.has_for_each = true;
  // An empty list is possible: one answer for all.
  if (const toml::array* const list = for_each->as_array(); list && list->empty()) return;
  claim.for_each = values_.texts(*for_each, "claim.for_each");
  for (const std::string& name : claim.for_each) values_.check_factor(*for_each, name, "claim.for_each");
}

void ClaimParser::read_conditions(Claim& claim) {
  if (const auto* const when = from_->get("applies_when"))
    claim.applies_when = values_.formula(*when, "claim.applies_when");
  const std::string side = text("applies_to", "both");
  const auto known = std::ranges::find(applies_to_names, side);
  if (known == applies_to_names.end()) {
    fail("applies_to",
         fmt::format("unknown applies_to \"{}\"; possible: {}", side, fmt::join(applies_to_names, ", ")));
  } else {
    claim.applies_to = static_cast<AppliesTo>(known - applies_to_names.begin());
  }
  read_holds(claim);
}

void ClaimParser::read_holds(Claim& claim) {
  const toml::node* const holds = from_->get("holds");
  if (!holds) return;
  claim.holds = values_.text(*holds, "claim.holds").value_or("all");
  const auto share = leading_number(claim.holds);
  const bool is_name = claim.holds == "all" || claim.holds == "any" || claim.holds == "most";
  if (!is_name && !(is_number(claim.holds) && *share > 0 && *share <= 1))
    fail("holds", "claim.holds must be \"all\", \"any\", \"most\" or a share of the groups above 0, up to 1");
}

void ClaimParser::read_ratio(Claim& claim) {
  for (const auto& [key, factors] : {std::pair{"of", &claim.of}, std::pair{"to", &claim.to}}) {
    if (const auto* const node = from_->get(key)) {
      *factors = values_.factors(*node, fmt::format("claim.{}", key));
    } else {
      fail(key, fmt::format("rule \"ratio\" needs {} = {{ FACTOR = VALUE }}", key));
    }
  }
}

void ClaimParser::read_key(Claim& claim) {
  claim.key = text("key");
  if (claim.key.empty()) {
    fail("key",
         fmt::format("rule \"{}\" needs a key: the factor whose values it compares", name_of(claim.rule)));
  } else {
    values_.check_factor(from_->contains("key") ? *from_->get("key") : *from_, claim.key, "claim.key");
  }
  claim.within = reader_.number_or(*from_, "within", 0, 0, 1);
  claim.smallest_first = reader_.truth_or(*from_, "smallest_first", false);
  claim.intercept = reader_.truth_or(*from_, "intercept", false);
  claim.at = value_of_key(claim, "at");
  claim.from = value_of_key(claim, "from");
  if (claim.rule == Rule::step && claim.at.empty())
    fail("at", "rule \"step\" needs at: the value of its key at which the step is");
  read_range_of_key(claim);
  if (claim.rule == Rule::linear) read_linear(claim);
}

void ClaimParser::read_linear(Claim& claim) {
  const std::string of = text("of", "value");
  claim.inverse = of == "inverse";
  if (of != "value" && of != "inverse")
    fail("of", fmt::format("unknown of \"{}\" of rule \"linear\"; possible: value, inverse", of));
}

std::string ClaimParser::value_of_key(const Claim& claim, const char* name) {
  const toml::node* const node = from_->get(name);
  if (!node) return {};
  const auto value = values_.text(*node, fmt::format("claim.{}", name));
  if (value) values_.check_value(*node, claim.key, *value);
  return value.value_or("");
}

void ClaimParser::read_range_of_key(Claim& claim) {
  if (const auto* const node = from_->get("values")) {
    claim.values = values_.texts(*node, "claim.values");
    for (const std::string& value : claim.values) values_.check_value(*node, claim.key, value);
  }
  const toml::node* const over = from_->get("over");
  if (!over) return;
  const toml::array* const pair = over->as_array();
  if (!pair || pair->size() != 2) {
    fail("over", "claim.over must be a range of numbers: [low, high]; values = [...] names single ones");
    return;
  }
  for (const toml::node& bound : *pair) claim.over.push_back(values_.formula(bound, "claim.over"));
}

void ClaimParser::read_expectation(Claim& claim) {
  const toml::node* const node = from_->get("expect");
  if (!node) return refuse_missing_expectation(claim);
  if (expects_values(claim.rule)) {
    claim.expected_values = values_.texts(*node, "claim.expect");
    for (const std::string& value : claim.expected_values) values_.check_value(*node, claim.key, value);
    if (claim.rule == Rule::order && claim.expected_values.size() < 2)
      fail("expect", "rule \"order\" needs two values of its key at least");
  } else if (const toml::table* const by_group = node->as_table()) {
    for (const auto& [group, range] : *by_group)
      claim.expect[std::string(group.str())] = values_.range(range);
  } else {
    claim.expect[""] = values_.range(*node);
  }
}

void ClaimParser::refuse_missing_expectation(const Claim& claim) {
  if (claim.rule == Rule::plateau || claim.rule == Rule::linear) return;  // they have a usual one
  fail("expect", fmt::format("rule \"{}\" needs expect: {}", name_of(claim.rule),
                             expects_values(claim.rule) ? "values of its key"
                                                        : "a range such as [1.2, 1.3] or \">= 1.5\""));
}

}  // namespace raysweep
