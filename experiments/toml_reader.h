// Reads a TOML document value by value, and collects what is wrong with it on the way.
#pragma once

#include <toml++/toml.h>

#include <string>
#include <string_view>
#include <vector>

namespace raysweep {

/// What configs of all kinds begin with.
struct ConfigHead {
  std::string experiment, title;
};

class TomlReader {
 public:
  /// `file` is told where a node does not know its own.
  explicit TomlReader(std::string file) : file_(std::move(file)) {}

  void fail(const toml::node& at, const std::string& sentence);
  void fail(toml::node_view<const toml::node> at, const std::string& sentence) { fail(*at.node(), sentence); }
  /// One line each, with file and line.
  [[nodiscard]] const std::string& errors() const { return errors_; }
  /// That is read.
  [[nodiscard]] const std::string& file() const { return file_; }
  /// Throws RequestError with all of them, if there are any.
  void refuse_errors() const;

  /// `where` is the table's name with its dot.
  void check_keys(const toml::table& table, const std::string& where,
                  const std::vector<std::string_view>& known);
  /// Of a whole config, whose kind has these `sections` beside those that all have.
  ConfigHead head(const toml::table& root, const std::vector<std::string_view>& sections);
  /// Null if there is none.
  const toml::table* section(const toml::table& root, std::string_view name);
  std::string text_or(const toml::table& table, std::string_view key, const std::string& otherwise);
  bool truth_or(const toml::table& table, std::string_view key, bool otherwise);
  double number_or(const toml::table& table, std::string_view key, double otherwise, double low, double high);
  int integer_or(const toml::table& table, std::string_view key, int otherwise, int low, int high);
  /// A number or a list of them.
  std::vector<double> numbers_or(const toml::table& table, std::string_view key, double otherwise, double low,
                                 double high);
  /// A name or a list of them, each once; "all" are those known, and so it is without the key.
  std::vector<std::string> names_or_all(const toml::table& table, std::string_view key,
                                        const std::vector<std::string_view>& known);
  /// In seconds.
  double duration_or(const toml::table& table, std::string_view key, double otherwise);
  /// What `experiment` says, which names the folder of the run.
  std::string experiment_name(const toml::table& root);

 private:
  std::string file_, errors_;
};

}  // namespace raysweep
