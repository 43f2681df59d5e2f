#include "experiments/config_toml.h"

#include <fmt/format.h>

#include <sstream>

#include "experiments/cell_factors.h"
#include "experiments/errors.h"

namespace raysweep {

namespace {

toml::table parse_toml(const std::string& text, const std::string& file) {
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    throw RequestError(
        fmt::format("{}:{}: not TOML: {}", file, error.source().begin.line, error.description()));
  }
}

/// `key=value` as a document: the value as TOML if it is any, as a string otherwise. A bare factor is one of
/// [sweep].
toml::table parse_override(const std::string& assignment) {
  const size_t equals = assignment.find('=');
  std::string key = assignment.substr(0, equals);
  if (equals == std::string::npos || key.empty()) {
    throw RequestError(
        fmt::format("--set {}: must be KEY=VALUE, such as threads=1..4 or measure.launches=3", assignment));
  }
  if (find_factor(key)) key = "sweep." + key;
  const std::string value = assignment.substr(equals + 1), where = "--set " + assignment;
  try {
    return toml::parse(key + " = " + value, where);
  } catch (const toml::parse_error&) {
    return parse_toml(fmt::format("{} = '{}'", key, value), where);
  }
}

/// Moves, since copies of nodes forget where they came from.
void merge(toml::table& into, toml::table&& from) {
  for (auto&& [key, value] : from) {
    toml::node* const old = into.get(key);
    if (old && old->is_table() && value.is_table()) {
      merge(*old->as_table(), std::move(*value.as_table()));
    } else {
      value.visit([&, name = key.str()](auto& node) { into.insert_or_assign(name, std::move(node)); });
    }
  }
}

}  // namespace

toml::table read_toml(const std::string& text, const std::string& file,
                      const std::vector<std::string>& overrides) {
  toml::table root = parse_toml(text, file);
  for (const std::string& assignment : overrides) merge(root, parse_override(assignment));
  return root;
}

std::string to_text(const toml::table& root) {
  std::ostringstream text;
  text << root << "\n";
  return text.str();
}

}  // namespace raysweep
