#include "experiments/variant_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace raysweep {

namespace {

template <class List, class Value>
bool contains(const List& list, const Value& value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

}  // namespace

bool VariantChoice::takes(const std::string& change) const { return is_star || contains(changes, change); }

std::vector<Inapplicable> left_out_of(const std::vector<Inapplicable>& all, const VariantChoice& choice,
                                      const std::vector<std::string>& methods,
                                      const std::vector<Precision>& precisions) {
  std::vector<std::string_view> names;
  for (const Precision precision : precisions) names.push_back(name_of(precision));
  std::vector<Inapplicable> list;
  for (const Inapplicable& one : all) {
    if (choice.takes(one.change) && contains(methods, one.method) && contains(names, one.precision))
      list.push_back(one);
  }
  return list;
}

nlohmann::json left_out_as_json(const std::vector<Inapplicable>& left_out) {
  auto list = nlohmann::json::array();
  for (const Inapplicable& one : left_out) {
    list.push_back({{"method", one.method},
                    {"change", one.change},
                    {"precision", one.precision},
                    {"reason", one.reason}});
  }
  return list;
}

VariantChoice read_variants(TomlReader& reader, const toml::table& table, std::string_view key,
                            const std::vector<std::string>& known) {
  const toml::node* const node = table.get(key);
  if (!node) return {};
  if (node->value_exact<std::string>() == "star") return {.is_star = true};
  VariantChoice choice;
  choice.changes.clear();
  const auto add = [&](const toml::node& one) {
    const auto change = one.value_exact<std::string>();
    if (!change) {
      reader.fail(one, fmt::format("{} must be strings in quotes", key));
    } else if (*change == "star") {
      reader.fail(one, fmt::format("{}: \"star\" stands alone: it has all others", key));
    } else if (*change != "base" && !contains(known, *change)) {
      reader.fail(one, fmt::format("unknown {} \"{}\"; possible: base, star, {}", key, *change,
                                   fmt::join(known, ", ")));
    } else if (!contains(choice.changes, *change)) {
      choice.changes.push_back(*change);
    }
  };
  const toml::array* const list = node->as_array();
  if (!list) {
    add(*node);
  } else {
    if (list->empty()) reader.fail(*node, fmt::format("{} is an empty list; name one value at least", key));
    for (const toml::node& one : *list) add(one);
  }
  return choice;
}

}  // namespace raysweep
