#include "experiments/claim_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <regex>

namespace raysweep {

namespace {

void add_once(std::vector<std::string>& list, const std::string& value) {
  if (std::ranges::find(list, value) == list.end()) list.push_back(value);
}

std::string as_text(const toml::node& node) {
  if (const auto text = node.value_exact<std::string>()) return *text;
  if (const auto number = node.value_exact<int64_t>()) return std::to_string(*number);
  if (const auto real = node.value_exact<double>()) return fmt::format("{}", *real);
  if (const auto truth = node.value_exact<bool>()) return *truth ? "true" : "false";
  return {};
}

}  // namespace

void ClaimValues::add_known(const PublishedTable& table) {
  for (const PrintedNumber& number : table.numbers) {
    for (const auto& [name, value] : number.factors) {
      const bool is_new = !scope_.factors.contains(name);
      auto& values = scope_.factors[name];
      if (is_new || !values.empty()) add_once(values, value);
    }
  }
}

std::optional<std::string> ClaimValues::text(const toml::node& node, const std::string& what) {
  if (std::string value = as_text(node); !value.empty()) return value;
  reader_.fail(node, fmt::format("{} must be a number or a string in quotes", what));
  return std::nullopt;
}

std::vector<std::string> ClaimValues::texts(const toml::node& node, const std::string& what) {
  std::vector<std::string> list;
  const toml::array* const array = node.as_array();
  if (!array) {
    if (auto value = text(node, what)) list.push_back(std::move(*value));
    return list;
  }
  if (array->empty()) reader_.fail(node, fmt::format("{} is an empty list; name one value at least", what));
  for (const toml::node& one : *array) {
    if (auto value = text(one, what)) list.push_back(std::move(*value));
  }
  return list;
}

std::string ClaimValues::formula(const toml::node& node, const std::string& what) {
  const auto value = text(node, what);
  if (!value) return {};
  try {
    constexpr MachineCounts any{4, 8};  // whichever: what is a formula does not depend on it
    (void)evaluate(*value, any);
  } catch (const ExpressionError& error) {
    reader_.fail(node, fmt::format("{}: {}", what, error.what()));
  }
  return *value;
}

void ClaimValues::check_factor(const toml::node& at, const std::string& name, const std::string& where) {
  if (scope_.factors.contains(name)) return;
  std::vector<std::string> names;
  for (const auto& [known, values] : scope_.factors) names.push_back(known);
  reader_.fail(at,
               fmt::format("unknown factor \"{}\" in {}; possible: {}", name, where, fmt::join(names, ", ")));
}

void ClaimValues::check_value(const toml::node& at, const std::string& name, const std::string& value) {
  const auto known = scope_.factors.find(name);
  if (!scope_.is_whole || known == scope_.factors.end() || known->second.empty()) return;
  // Which numbers a sweep has depends on the machine.
  if (leading_number(value) || mentions_machine(value)) return;
  const auto is_it = [&](const std::string& one) { return is_same_value(one, value); };
  if (std::ranges::any_of(known->second, is_it)) return;
  reader_.fail(at, fmt::format("{} \"{}\" is neither swept nor printed; there are: {}", name, value,
                               fmt::join(known->second, ", ")));
}

const toml::table* ClaimValues::table(const toml::node& node, const std::string& where) {
  if (!node.is_table())
    reader_.fail(node, fmt::format("{} must be a table of factors, such as {{ threads = 12 }}", where));
  return node.as_table();
}

Factors ClaimValues::factors(const toml::node& node, const std::string& where) {
  Factors made;
  const toml::table* const from = table(node, where);
  if (!from) return made;
  for (const auto& [key, value] : *from) {
    const std::string name(key.str());
    check_factor(value, name, where);
    if (const auto one = text(value, fmt::format("{}.{}", where, name))) {
      check_value(value, name, *one);
      made[name] = *one;
    }
  }
  return made;
}

Selector ClaimValues::selector(const toml::node& node, const std::string& where) {
  Selector made;
  const toml::table* const from = table(node, where);
  if (!from) return made;
  for (const auto& [key, value] : *from) {
    const std::string name(key.str());
    check_factor(value, name, where);
    made[name] = texts(value, fmt::format("{}.{}", where, name));
    for (const std::string& one : made[name]) check_value(value, name, one);
  }
  return made;
}

ExpectedRange ClaimValues::range(const toml::node& node) {
  static const std::regex comparison(R"(\s*(<=|>=|<|>)\s*(.+))");
  if (const toml::array* const pair = node.as_array(); pair && pair->size() == 2)
    return {formula(*pair->get(0), "claim.expect"), formula(*pair->get(1), "claim.expect"), false, false};
  std::smatch parts;
  const std::string text = node.value_exact<std::string>().value_or("");
  if (!std::regex_match(text, parts, comparison)) {
    reader_.fail(node, "claim.expect must be a range: [low, high], \"<= X\", \">= X\", \"< X\" or \"> X\"");
    return {};
  }
  const std::string sign = parts[1], bound = parts[2];
  try {
    (void)evaluate(bound, {4, 8});
  } catch (const ExpressionError& error) {
    reader_.fail(node, fmt::format("claim.expect: {}", error.what()));
  }
  const bool is_open = sign.size() == 1;
  if (sign.front() == '<') return {"", bound, false, is_open};
  return {bound, "", is_open, false};
}

}  // namespace raysweep
