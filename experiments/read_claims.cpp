#include "experiments/read_claims.h"

#include <fmt/format.h>

#include "experiments/claim_parser.h"
#include "experiments/published_config.h"

namespace raysweep {

namespace {

/// A comment in the first line, without its sign; empty if there is none.
std::string first_comment(const std::string& text) {
  const std::string line = text.substr(0, text.find('\n'));
  const size_t begin = line.find_first_not_of("# \t");
  if (line.empty() || line.front() != '#' || begin == std::string::npos) return {};
  return line.substr(begin, line.find_last_not_of(" \t\r") + 1 - begin);
}

void read_quick(TomlReader& reader, ClaimValues& values, const toml::table& root, ClaimsConfig& config) {
  const toml::table* const quick = reader.section(root, "quick");
  if (!quick) return;
  reader.check_keys(*quick, "quick.", {"set"});
  const toml::node* const set = quick->get("set");
  if (!set) {
    reader.fail(*quick, "[quick] needs set: what a quick run changes, such as [\"threads=[1,2]\"]");
    return;
  }
  config.quick = values.texts(*set, "quick.set");
  for (const std::string& one : config.quick) {
    if (const size_t equals = one.find('='); equals == 0 || equals == std::string::npos)
      reader.fail(*set, fmt::format("\"{}\" in quick.set must be KEY=VALUE, as --set has it", one));
  }
}

}  // namespace

std::vector<std::string> quick_overrides(const toml::table& root) {
  std::vector<std::string> list;
  if (const toml::array* const set = root["quick"]["set"].as_array()) {
    for (const toml::node& one : *set) list.push_back(one.value_or(std::string()));
  }
  return list;
}

ClaimsConfig read_claims(TomlReader& reader, const toml::table& root, const std::string& text,
                         const ClaimScope& scope) {
  ClaimsConfig config;
  config.sheet.question = first_comment(text);
  ClaimValues values(reader, scope);
  config.sheet.published = read_published_table(reader, values, root, scope);
  if (config.sheet.published) values.add_known(*config.sheet.published);
  read_quick(reader, values, root, config);
  const toml::node* const node = root.get("claim");
  if (!node) return config;
  if (!node->is_array_of_tables()) {
    reader.fail(*node, "claims are tables of a list, each under a line [[claim]]");
    return config;
  }
  ClaimParser parser(reader, values, scope);
  for (const toml::node& one : *node->as_array()) config.sheet.claims.push_back(parser.read(*one.as_table()));
  return config;
}

}  // namespace raysweep
