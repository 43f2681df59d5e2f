#include "experiments/read_claims.h"

#include <fmt/format.h>

#include <filesystem>

#include "experiments/claim_parser.h"
#include "experiments/published_config.h"

namespace raysweep {

namespace {

namespace fs = std::filesystem;

/// A comment in the first line, without its sign; empty if there is none.
std::string first_comment(const std::string& text) {
  const std::string line = text.substr(0, text.find('\n'));
  const size_t begin = line.find_first_not_of("# \t");
  if (line.empty() || line.front() != '#' || begin == std::string::npos) return {};
  return line.substr(begin, line.find_last_not_of(" \t\r") + 1 - begin);
}

/// In quotes where a shell would read more into it.
std::string shell_word(const std::string& word) {
  const bool is_plain =
      word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/") ==
      std::string::npos;
  if (is_plain) return word;
  std::string quoted = "'";
  for (const char c : word) quoted.append(c == '\'' ? "'\\''" : std::string(1, c));
  return quoted.append("'");
}

/// What makes the run, from the top of the sources where the config is one of theirs.
std::string command_of(const std::string& file, const std::vector<std::string>& overrides) {
  const fs::path sources = fs::path(RAYSWEEP_RESULTS_DIR).parent_path();
  const fs::path relative = fs::weakly_canonical(file).lexically_relative(fs::weakly_canonical(sources));
  const bool is_ours = !relative.empty() && *relative.begin() != "..";
  std::string command = fmt::format("raysweep run {}", shell_word(is_ours ? relative.string() : file));
  for (const std::string& one : overrides) command += fmt::format(" --set {}", shell_word(one));
  return command;
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

ClaimsConfig read_claims(TomlReader& reader, const toml::table& root, ConfigRequest request,
                         ClaimScope scope) {
  ClaimsConfig config;
  scope.is_whole = request.overrides.empty();
  config.sheet.question = first_comment(request.text);
  config.sheet.command = command_of(reader.file(), request.overrides);
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
