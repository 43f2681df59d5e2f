// Which variants of its methods a study runs.
#pragma once

#include <algorithm>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/intersection/accuracy.h"
#include "experiments/intersection/subjects.h"
#include "experiments/toml_reader.h"

namespace raysweep {

/// By the change that makes a variant of its method's base: "base", "division=late", "rays=4".
struct VariantChoice {
  bool is_star = false;                      // all that differ from the base in one factor, and the base
  std::vector<std::string> changes{"base"};  // else these

  [[nodiscard]] bool takes(const std::string& change) const;
};

/// Of `all` those that are asked for, of one of `methods` and one of `precisions`.
[[nodiscard]] std::vector<Inapplicable> left_out_of(const std::vector<Inapplicable>& all,
                                                    const VariantChoice& choice,
                                                    const std::vector<std::string>& methods,
                                                    const std::vector<Precision>& precisions);

/// As plan.json lists them.
[[nodiscard]] nlohmann::json left_out_as_json(const std::vector<Inapplicable>& left_out);

/// The changes that `lists` of subjects, kernels or inapplicable variants name, each once, without "base".
template <class... Lists>
[[nodiscard]] std::vector<std::string> changes_of(const Lists&... lists) {
  std::vector<std::string> changes{"base"};
  const auto add = [&](const auto& list) {
    for (const auto& one : list) {
      if (std::find(changes.begin(), changes.end(), one.change) == changes.end())
        changes.push_back(one.change);
    }
  };
  (add(lists), ...);
  changes.erase(changes.begin());
  return changes;
}

/// The key's value: "base", which it is without the key too, "star", a change, or a list of changes, each
/// once. Of `known` and "base" every change is possible; a method that lacks one is left out there.
[[nodiscard]] VariantChoice read_variants(TomlReader& reader, const toml::table& table, std::string_view key,
                                          const std::vector<std::string>& known);

}  // namespace raysweep
