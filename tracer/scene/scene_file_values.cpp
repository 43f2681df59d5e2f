#include "tracer/scene/scene_file_values.h"

#include <fmt/format.h>

#include <algorithm>

#include "tracer/scene/scenes.h"

namespace raysweep {

namespace {

/// On one line, whatever names and other people's messages hold.
std::string one_line(std::string_view sentence) {
  std::string line(sentence);
  std::ranges::replace_if(
      line, [](char c) { return static_cast<unsigned char>(c) < ' ' || c == 127; }, ' ');
  while (line.ends_with(' ')) line.pop_back();
  return line;
}

std::string describe(NumberRange range) {
  return fmt::format(fmt::runtime(range.open ? "above {:.7g} and below {:.7g}" : "from {:.7g} to {:.7g}"),
                     range.low, range.high);
}

}  // namespace

void SceneErrors::add(const toml::node& at, std::string_view sentence) {
  errors_.emplace_back(std::max(at.source().begin.line, toml::source_index{1}), one_line(sentence));
}

void SceneErrors::throw_any() const {
  if (errors_.empty()) return;
  auto sorted = errors_;
  std::ranges::stable_sort(sorted, {}, [](const auto& error) { return error.first; });
  constexpr size_t shown = 100;  // a list of a million bad numbers is told by its first
  std::string text;
  for (const auto& [line, sentence] : std::span(sorted).first(std::min(shown, sorted.size()))) {
    text += fmt::format("{}{}:{}: {}", text.empty() ? "" : "\n", file_, line, sentence);
  }
  if (sorted.size() > shown) {
    text += fmt::format("\n{}:{}: and {} more errors from here on", file_, sorted[shown].first,
                        sorted.size() - shown);
  }
  throw SceneError(text);
}

void SceneTable::fail(std::string_view key, std::string_view sentence) const {
  const toml::node* const at = table_.get(key);
  errors_.add(at ? *at : table_, sentence);
}

void SceneTable::check_keys(const Keys& needed, const Keys& optional) const {
  for (const std::string_view key : needed) {
    if (!table_.contains(key)) errors_.add(table_, fmt::format("{} needs the key \"{}\"", what_, key));
  }
  Keys known = needed;
  known.insert(known.end(), optional.begin(), optional.end());
  for (const auto& [key, value] : table_) {
    if (std::ranges::find(known, key.str()) != known.end()) continue;
    errors_.add(value, fmt::format("unknown key \"{}\" in {}; possible: {}", key.str(), what_,
                                   fmt::join(known, ", ")));
  }
}

std::optional<double> number_of(const toml::node& node) {
  if (const auto whole = node.value_exact<int64_t>()) return static_cast<double>(*whole);
  return node.value_exact<double>();
}

std::optional<Vec3d> vector_of(const toml::node& node, NumberRange range) {
  const toml::array* const list = node.as_array();
  if (!list || list->size() != 3) return std::nullopt;
  const auto x = number_of((*list)[0]), y = number_of((*list)[1]), z = number_of((*list)[2]);
  for (const auto& v : {x, y, z}) {
    if (!v || !range.contains(*v)) return std::nullopt;
  }
  return Vec3d(*x, *y, *z);
}

std::optional<double> SceneTable::number(std::string_view key, NumberRange range) const {
  const toml::node* const node = table_.get(key);
  if (!node) return std::nullopt;
  const auto value = number_of(*node);
  if (value && range.contains(*value)) return value;
  errors_.add(*node, fmt::format("{} must be a number {}", key, describe(range)));
  return std::nullopt;
}

std::optional<int> SceneTable::integer(std::string_view key, NumberRange range) const {
  const toml::node* const node = table_.get(key);
  if (!node) return std::nullopt;
  const auto value = node->value_exact<int64_t>();
  if (value && range.contains(static_cast<double>(*value))) return static_cast<int>(*value);
  errors_.add(*node, fmt::format("{} must be a whole number {}", key, describe(range)));
  return std::nullopt;
}

std::optional<bool> SceneTable::flag(std::string_view key) const {
  const toml::node* const node = table_.get(key);
  if (!node) return std::nullopt;
  const auto value = node->value_exact<bool>();
  if (!value) errors_.add(*node, fmt::format("{} must be true or false", key));
  return value;
}

std::optional<std::string> SceneTable::text(std::string_view key) const {
  const toml::node* const node = table_.get(key);
  if (!node) return std::nullopt;
  auto value = node->value_exact<std::string>();
  if (!value) errors_.add(*node, fmt::format("{} must be a string in quotes", key));
  return value;
}

std::optional<Vec3d> SceneTable::vector(std::string_view key, NumberRange range,
                                        std::string_view must_be) const {
  const toml::node* const node = table_.get(key);
  if (!node) return std::nullopt;
  const auto value = vector_of(*node, range);
  if (!value) errors_.add(*node, fmt::format("{} must be {} {}", key, must_be, describe(range)));
  return value;
}

std::optional<Vec3d> SceneTable::point(std::string_view key) const {
  return vector(key, coordinate_range, "three numbers [x, y, z], each");
}

std::optional<Vec3d> SceneTable::angles(std::string_view key) const {
  return vector(key, {-360, 360}, "three angles [x, y, z] in degrees, each");
}

std::optional<Vec3d> SceneTable::direction(std::string_view key) const {
  const auto value = point(key);
  if (!value) return std::nullopt;
  const double largest = max_abs(*value);
  if (largest == 0) {
    fail(key, fmt::format("{} must not be [0, 0, 0]: it tells a direction", key));
    return std::nullopt;
  }
  // Divided first: the square of a very small number is 0.
  return normalize(Vec3d(value->x / largest, value->y / largest, value->z / largest));
}

std::optional<Colour> SceneTable::colour(std::string_view key) const {
  return vector(key, light_range, "a colour [red, green, blue], each");
}

std::vector<const toml::node*> SceneTable::list(std::string_view key, std::string_view of_what) const {
  const toml::node* const node = table_.get(key);
  std::vector<const toml::node*> elements;
  if (!node) return elements;
  if (const toml::array* const array = node->as_array()) {
    for (const toml::node& element : *array) elements.push_back(&element);
  } else {
    errors_.add(*node, fmt::format("{} must be {}", key, of_what));
  }
  return elements;
}

}  // namespace raysweep
