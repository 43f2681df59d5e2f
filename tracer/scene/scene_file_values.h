// Typed values out of a scene file's TOML, with every error collected on the way.
#pragma once

#include <toml++/toml.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tracer/scene/scene.h"

namespace raysweep {

/// What is wrong in one scene file.
class SceneErrors {
 public:
  explicit SceneErrors(std::string file) : file_(std::move(file)) {}

  void add(const toml::node& at, std::string_view sentence);

  /// Throws SceneError with the errors in the order of their lines; returns if there are none.
  void throw_any() const;

 private:
  std::string file_;
  std::vector<std::pair<toml::source_index, std::string>> errors_;  // line, sentence
};

/// Bounds of a number; both belong to it unless it is `open`.
struct NumberRange {
  double low, high;
  bool open = false;

  [[nodiscard]] bool contains(double v) const { return open ? v > low && v < high : v >= low && v <= high; }
};

/// Floats hold these, and sums of a few.
inline constexpr NumberRange coordinate_range{-1e12, 1e12};
/// Of sizes: what is smaller is nothing where numbers are floats.
inline constexpr NumberRange size_range{1e-12, 1e12};
/// Of brightness, colours and coefficients.
inline constexpr NumberRange light_range{0, 1e6};

/// One table of a scene file, and what it describes, such as "a sphere". A reader gives nothing where its key
/// is missing, and nothing and an error where the value is no such thing.
class SceneTable {
 public:
  using Keys = std::vector<std::string_view>;

  SceneTable(const toml::table& table, std::string what, SceneErrors& errors)
      : table_(table), what_(std::move(what)), errors_(errors) {}

  /// Adds an error for each key that is missing and for each that is unknown.
  void check_keys(const Keys& needed, const Keys& optional) const;

  [[nodiscard]] std::optional<double> number(std::string_view key, NumberRange range) const;
  [[nodiscard]] std::optional<int> integer(std::string_view key, NumberRange range) const;
  [[nodiscard]] std::optional<bool> flag(std::string_view key) const;
  [[nodiscard]] std::optional<std::string> text(std::string_view key) const;
  [[nodiscard]] std::optional<Vec3d> point(std::string_view key) const;
  [[nodiscard]] std::optional<Vec3d> angles(std::string_view key) const;
  /// Of length 1, from a vector of any other length but 0.
  [[nodiscard]] std::optional<Vec3d> direction(std::string_view key) const;
  [[nodiscard]] std::optional<Colour> colour(std::string_view key) const;

  /// The elements of a list; none if the key is missing.
  [[nodiscard]] std::vector<const toml::node*> list(std::string_view key, std::string_view of_what) const;

  [[nodiscard]] const toml::node* node(std::string_view key) const { return table_.get(key); }
  [[nodiscard]] SceneErrors& errors() const { return errors_; }
  /// Adds an error where `key` is, or where the table begins if it is missing.
  void fail(std::string_view key, std::string_view sentence) const;

 private:
  [[nodiscard]] std::optional<Vec3d> vector(std::string_view key, NumberRange range,
                                            std::string_view must_be) const;

  const toml::table& table_;
  std::string what_;
  SceneErrors& errors_;
};

/// A number, whole or not.
[[nodiscard]] std::optional<double> number_of(const toml::node& node);

/// Three numbers in a list, all in `range`.
[[nodiscard]] std::optional<Vec3d> vector_of(const toml::node& node, NumberRange range);

}  // namespace raysweep
