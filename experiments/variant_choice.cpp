#include "experiments/variant_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "experiments/intersection/kernel_modules.h"

namespace raysweep {

namespace {

template <class List, class Value>
bool contains(const List& list, const Value& value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

}  // namespace

bool VariantChoice::takes(const std::string& change, bool combines) const {
  if (is_list()) return contains(changes, change);
  return is_product || !combines;
}

void KnownChanges::add(const std::string& change, bool combines) {
  std::vector<std::string>& list = combines ? combined : single;
  if (change != "base" && !contains(list, change)) list.push_back(change);
}

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
                            const KnownChanges& known) {
  const toml::node* const node = table.get(key);
  if (!node) return {};
  const auto whole = node->value_exact<std::string>();
  if (whole == "star") return {.is_star = true};
  if (whole == "product") {
    if (const std::string why = why_no_kernels("combined"); !why.empty())
      reader.fail(*node, fmt::format("{} \"product\" cannot be used here: it {}; configure with "
                                     "-DRAYSWEEP_COMBINED_KERNELS=ON and build all targets",
                                     key, why));
    return {.is_product = true};
  }
  VariantChoice choice;
  choice.changes.clear();
  const auto add = [&](const toml::node& one) {
    const auto change = one.value_exact<std::string>();
    if (!change) {
      reader.fail(one, fmt::format("{} must be strings in quotes", key));
    } else if (*change == "star" || *change == "product") {
      reader.fail(one, fmt::format("{}: \"{}\" stands alone", key, *change));
    } else if (*change != "base" && !contains(known.single, *change) && !contains(known.combined, *change)) {
      reader.fail(one, fmt::format("unknown {} \"{}\"; possible: base, star, product, {}", key, *change,
                                   fmt::join(known.single, ", ")));
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
