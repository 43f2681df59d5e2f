#include "experiments/include_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "experiments/config.h"
#include "experiments/config_toml.h"
#include "experiments/errors.h"
#include "experiments/toml_reader.h"

namespace raysweep {

namespace {

class IncludeReader : public TomlReader {
 public:
  explicit IncludeReader(const std::string& file)
      : TomlReader(file), folder_(std::filesystem::path(file).parent_path()) {}

  IncludeList read(const toml::table& root) {
    check_keys(root, "", {"experiment", "title", "include"});
    IncludeList list{experiment_name(root), {}};
    (void)text_or(root, "title", list.name);
    const toml::node& include = *root.get("include");
    const toml::array* const names = include.as_array();
    if (!names || names->empty()) {
      fail(include, "include must be a list of files, such as [\"m11-t3.toml\", \"m11-t4.toml\"]");
      return list;
    }
    for (const toml::node& name : *names) add(list.files, name);
    return list;
  }

 private:
  void add(std::vector<std::string>& files, const toml::node& name) {
    const auto text = name.value_exact<std::string>();
    if (!text) {
      fail(name, "include must be strings in quotes");
      return;
    }
    std::string file = (folder_ / *text).string();
    if (!std::filesystem::is_regular_file(file)) {
      fail(name, fmt::format("include \"{}\": there is no file {}", *text, file));
    } else if (std::ranges::find(files, file) != files.end()) {
      fail(name, fmt::format("include \"{}\": it is there twice", *text));
    } else if (includes_files(file)) {
      fail(name, fmt::format("include \"{}\": it includes files itself; name these here", *text));
    } else {
      files.push_back(std::move(file));
    }
  }

  /// What is no TOML is told when it is read as an experiment.
  static bool includes_files(const std::string& file) {
    try {
      return read_toml(read_config_text(file), file, {}).contains("include");
    } catch (const RequestError&) {
      return false;
    }
  }

  std::filesystem::path folder_;
};

}  // namespace

std::optional<IncludeList> read_include_list(const std::string& text, const std::string& file) {
  const toml::table root = read_toml(text, file, {});
  if (!root.contains("include")) return std::nullopt;
  IncludeReader reader(file);
  IncludeList list = reader.read(root);
  reader.refuse_errors();
  return list;
}

}  // namespace raysweep
