#include "experiments/toml_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/config.h"
#include "experiments/errors.h"

namespace raysweep {

void TomlReader::fail(const toml::node& at, const std::string& sentence) {
  const toml::source_region& source = at.source();
  errors_ += fmt::format("{}:{}: {}\n", source.path ? *source.path : file_, source.begin.line, sentence);
}

void TomlReader::refuse_errors() const {
  if (!errors_.empty()) throw RequestError(errors_.substr(0, errors_.size() - 1));
}

ConfigHead TomlReader::head(const toml::table& root, const std::vector<std::string_view>& sections) {
  std::vector<std::string_view> keys{"experiment", "title", "kind"};
  keys.insert(keys.end(), sections.begin(), sections.end());
  keys.insert(keys.end(), {"claim", "published", "quick"});
  check_keys(root, "", keys);
  const std::string experiment = experiment_name(root);
  return {experiment, text_or(root, "title", experiment)};
}

std::string TomlReader::experiment_name(const toml::table& root) {
  std::string name = text_or(root, "experiment", "");
  if (name.empty() || name.find('/') != std::string::npos)
    fail(root, "experiment must be a name, such as \"M11-T3\"; it names the folder of the run");
  return name;
}

void TomlReader::check_keys(const toml::table& table, const std::string& where,
                            const std::vector<std::string_view>& known) {
  for (const auto& [key, value] : table) {
    if (std::ranges::find(known, key.str()) != known.end()) continue;
    fail(value, fmt::format("unknown key \"{}{}\"; possible: {}", where, key.str(), fmt::join(known, ", ")));
  }
}

const toml::table* TomlReader::section(const toml::table& root, std::string_view name) {
  const toml::node* const node = root.get(name);
  if (!node) return nullptr;
  if (!node->is_table()) fail(*node, fmt::format("\"{}\" must be a table: [{}]", name, name));
  return node->as_table();
}

std::string TomlReader::text_or(const toml::table& table, std::string_view key,
                                const std::string& otherwise) {
  const toml::node* const node = table.get(key);
  if (!node) return otherwise;
  if (const auto text = node->value_exact<std::string>()) return *text;
  fail(*node, fmt::format("{} must be a string in quotes", key));
  return otherwise;
}

bool TomlReader::truth_or(const toml::table& table, std::string_view key, bool otherwise) {
  const toml::node* const node = table.get(key);
  if (!node) return otherwise;
  if (const auto truth = node->value_exact<bool>()) return *truth;
  fail(*node, fmt::format("{} must be true or false", key));
  return otherwise;
}

double TomlReader::number_or(const toml::table& table, std::string_view key, double otherwise, double low,
                             double high) {
  const toml::node* const node = table.get(key);
  if (!node) return otherwise;
  const auto number = node->is_number() ? node->value<double>() : std::nullopt;
  if (number && *number >= low && *number <= high) return *number;
  fail(*node, fmt::format("{} must be a number from {} to {}", key, low, high));
  return otherwise;
}

int TomlReader::integer_or(const toml::table& table, std::string_view key, int otherwise, int low, int high) {
  const toml::node* const node = table.get(key);
  if (!node) return otherwise;
  const auto number = node->value_exact<int64_t>();
  if (number && *number >= low && *number <= high) return static_cast<int>(*number);
  fail(*node, fmt::format("{} must be a whole number from {} to {}", key, low, high));
  return otherwise;
}

std::vector<double> TomlReader::numbers_or(const toml::table& table, std::string_view key, double otherwise,
                                           double low, double high) {
  const toml::node* const node = table.get(key);
  if (!node) return {otherwise};
  std::vector<double> numbers;
  const auto add = [&](const toml::node& one) {
    const auto number = one.is_number() ? one.value<double>() : std::nullopt;
    if (number && *number >= low && *number <= high) {
      if (std::ranges::find(numbers, *number) == numbers.end()) numbers.push_back(*number);
    } else {
      fail(one, fmt::format("{} must be numbers from {} to {}", key, low, high));
    }
  };
  if (const toml::array* const list = node->as_array()) {
    if (list->empty()) fail(*node, fmt::format("{} is an empty list; name one value at least", key));
    for (const toml::node& one : *list) add(one);
  } else {
    add(*node);
  }
  return numbers;
}

std::vector<std::string> TomlReader::names_or_all(const toml::table& table, std::string_view key,
                                                  const std::vector<std::string_view>& known) {
  std::vector<std::string> all(known.begin(), known.end());
  const toml::node* const node = table.get(key);
  if (!node) return all;
  std::vector<std::string> names;
  const auto add = [&](const toml::node& one) {
    const auto name = one.value_exact<std::string>();
    if (!name) {
      fail(one, fmt::format("{} must be strings in quotes", key));
    } else if (*name != "all" && std::find(all.begin(), all.end(), *name) == all.end()) {
      fail(one, fmt::format("unknown {} \"{}\"; built here: {}, all", key, *name, fmt::join(known, ", ")));
    } else {
      for (const std::string& each : *name == "all" ? all : std::vector<std::string>{*name}) {
        if (std::find(names.begin(), names.end(), each) == names.end()) names.push_back(each);
      }
    }
  };
  if (const toml::array* const list = node->as_array()) {
    if (list->empty()) fail(*node, fmt::format("{} is an empty list; name one value at least", key));
    for (const toml::node& one : *list) add(one);
  } else {
    add(*node);
  }
  return names;
}

double TomlReader::duration_or(const toml::table& table, std::string_view key, double otherwise) {
  const toml::node* const node = table.get(key);
  if (!node) return otherwise;
  const double duration = parse_duration(node->value_exact<std::string>().value_or(""));
  if (duration == 0)
    fail(*node, fmt::format("{} must be a duration such as \"90 s\", \"10 min\" or \"2 h\"", key));
  return duration;
}

}  // namespace raysweep
