// Which variants of its methods a study runs.
#pragma once

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
  bool is_product = false;                   // besides, what there is of several factors at once
  std::vector<std::string> changes{"base"};  // where it is neither, these

  [[nodiscard]] bool is_list() const { return !is_star && !is_product; }
  /// `combines`: whether the change is one of several factors.
  [[nodiscard]] bool takes(const std::string& change, bool combines = false) const;
};

/// Of `all` those that are asked for, of one of `methods` and one of `precisions`.
[[nodiscard]] std::vector<Inapplicable> left_out_of(const std::vector<Inapplicable>& all,
                                                    const VariantChoice& choice,
                                                    const std::vector<std::string>& methods,
                                                    const std::vector<Precision>& precisions);

/// As plan.json lists them.
[[nodiscard]] nlohmann::json left_out_as_json(const std::vector<Inapplicable>& left_out);

/// Changes that a config may name, each once, without "base".
struct KnownChanges {
  std::vector<std::string> single, combined;  // of one factor, of several at once

  void add(const std::string& change, bool combines);
};

/// Those of subjects or kernels of both precisions, and of variants that do not exist.
template <class Of>
[[nodiscard]] KnownChanges changes_of(const Of& floats, const auto& doubles,
                                      const std::vector<Inapplicable>& absent) {
  KnownChanges known;
  for (const auto& one : floats) known.add(one.change, one.combines);
  for (const auto& one : doubles) known.add(one.change, one.combines);
  for (const Inapplicable& one : absent) known.add(one.change, false);
  return known;
}

/// The key's value: "base", which it is without the key too, "star", "product", a change, or a list of
/// changes, each once. Of `known` and "base" every change is possible; a method that lacks one is left out
/// there.
[[nodiscard]] VariantChoice read_variants(TomlReader& reader, const toml::table& table, std::string_view key,
                                          const KnownChanges& known);

}  // namespace raysweep
