// Values in claims: texts, formulas of the machine, factors and their values, each checked.
#pragma once

#include <toml++/toml.h>

#include <optional>
#include <string>
#include <vector>

#include "experiments/claims_config.h"
#include "experiments/toml_reader.h"

namespace raysweep {

class ClaimValues {
 public:
  ClaimValues(TomlReader& reader, const ClaimScope& scope) : reader_(reader), scope_(scope) {}

  /// What is printed is known too.
  void add_known(const PublishedTable& table);

  /// A string, a number or a truth as text; else fails, calling it `what`.
  std::optional<std::string> text(const toml::node& node, const std::string& what);
  /// One or a list of them.
  std::vector<std::string> texts(const toml::node& node, const std::string& what);
  /// A number or a formula of cores, pus and smt.
  std::string formula(const toml::node& node, const std::string& what);
  void check_factor(const toml::node& at, const std::string& name, const std::string& where);
  void check_value(const toml::node& at, const std::string& name, const std::string& value);
  /// { factor = value }
  Factors factors(const toml::node& node, const std::string& where);
  /// { factor = value or list of values }
  Selector selector(const toml::node& node, const std::string& where);
  /// [low, high] or "<= X", ">= X", "< X", "> X".
  ExpectedRange range(const toml::node& node);

 private:
  /// As a table; else fails.
  const toml::table* table(const toml::node& node, const std::string& where);

  TomlReader& reader_;
  ClaimScope scope_;
};

}  // namespace raysweep
