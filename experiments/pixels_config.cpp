#include "experiments/pixels_config.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "experiments/claim_scopes.h"
#include "experiments/config_toml.h"
#include "experiments/read_claims.h"
#include "experiments/toml_reader.h"
#include "tracer/sample/pattern.h"
#include "tracer/scene/scenes.h"

namespace raysweep {

namespace {

std::vector<std::string_view> names_of(std::span<const Choice> choices) {
  std::vector<std::string_view> names;
  for (const Choice& choice : choices) names.push_back(choice.name);
  return names;
}

class PixelsParser : public TomlReader {
 public:
  explicit PixelsParser(PixelsConfig& config) : TomlReader(config.file), config_(config) {}

  void read(const toml::table& root) {
    const ConfigHead of_all = head(root, {"sweep", "measure"});
    config_.settings.experiment = of_all.experiment;
    config_.title = of_all.title;
    const toml::table none;
    const toml::table* const sweep = section(root, "sweep");
    read_sweep(sweep ? *sweep : none);
    const toml::table* const measure = section(root, "measure");
    read_measure(measure ? *measure : none);
  }

 private:
  struct NamedScene {
    std::string name, file;
  };

  void read_sweep(const toml::table& sweep) {
    check_keys(sweep, "sweep.",
               {"scene", "offset", "mode", "core", "method", "precision", "pattern", "subpixels"});
    const std::vector<NamedScene> scenes = read_scenes(sweep);
    // Coordinates beyond would not hold anything of a scene a few units large, even in double.
    const std::vector<double> offsets = numbers_or(sweep, "offset", 0, -1e9, 1e9);
    std::vector<std::string_view> mode_names;
    for (const Mode& mode : modes()) mode_names.push_back(mode.name);
    const auto chosen_modes =
        sweep.contains("mode") ? names_or_all(sweep, "mode", mode_names) : std::vector<std::string>{"low"};
    const std::vector<PixelsSubject> subjects = read_subjects(sweep);
    for (const NamedScene& scene : scenes) {
      for (const double offset : offsets) {
        for (const std::string& mode : chosen_modes)
          config_.groups.push_back({scene.name, mode, scene.file, offset, subjects});
      }
    }
  }

  std::vector<NamedScene> read_scenes(const toml::table& sweep) {
    std::vector<NamedScene> scenes;
    const auto add = [&](const toml::node& one) {
      const auto name = one.value_exact<std::string>();
      if (!name) {
        fail(one, "scene must be strings in quotes");
      } else if (std::ranges::find(scenes, *name, &NamedScene::name) == scenes.end()) {
        scenes.push_back({*name, scene_file(one, *name)});
      }
    };
    const toml::node* const node = sweep.get("scene");
    if (!node) return {{"studio", "studio"}};
    const toml::array* const list = node->as_array();
    if (list && list->empty()) fail(*node, "scene is an empty list; name one value at least");
    if (list) {
      for (const toml::node& one : *list) add(one);
    } else {
      add(*node);
    }
    return scenes;
  }

  /// A built-in scene's name as it is; a file from where the config is.
  std::string scene_file(const toml::node& node, const std::string& name) {
    if (std::ranges::find(built_in_scenes(), name, &BuiltInScene::name) != built_in_scenes().end())
      return name;
    std::string file = (std::filesystem::path(config_.file).parent_path() / name).string();
    try {
      (void)own_light_count(file);
    } catch (const SceneError& error) {
      fail(node, error.what());
    }
    return file;
  }

  std::vector<PixelsSubject> read_subjects(const toml::table& sweep) {
    std::vector<PixelsSubject> subjects;
    const auto chosen_methods = names_or_all(sweep, "method", names_of(methods()));
    const auto chosen_precisions = names_or_all(sweep, "precision", names_of(precisions()));
    const auto samplings = read_samplings(sweep);
    for (const std::string& core : names_or_all(sweep, "core", names_of(cores()))) {
      for (const std::string& precision : chosen_precisions) {
        if (core == "wide" && precision != "float") {
          config_.left_out.push_back("core wide in " + precision + ": it has floats alone");
          continue;
        }
        for (const std::string& method : chosen_methods) {
          for (const auto& [pattern, samples] : samplings)
            subjects.push_back({core, method, precision, pattern, samples});
        }
      }
    }
    if (subjects.empty() && errors().empty())
      fail(sweep, fmt::format("nothing is left to run: {}", fmt::join(config_.left_out, "; ")));
    return subjects;
  }

  struct Sampling {
    std::string pattern;
    int subpixels;
  };

  /// What is not swept is empty or 0.
  std::vector<Sampling> read_samplings(const toml::table& sweep) {
    sweeps_samples_ = sweep.contains("pattern") || sweep.contains("subpixels");
    const std::vector<std::string> patterns = read_patterns(sweep);
    const std::vector<double> counts = whole_numbers(sweep, "subpixels");
    std::vector<Sampling> samplings;
    for (const std::string& pattern : patterns) {
      for (const double count : counts) samplings.push_back({pattern, static_cast<int>(count)});
    }
    return samplings;
  }

  std::vector<std::string> read_patterns(const toml::table& sweep) {
    const toml::node* const node = sweep.get("pattern");
    if (!node) return {""};
    std::vector<std::string> patterns;
    const auto add = [&](const toml::node& one) {
      const std::string name = one.value_exact<std::string>().value_or("");
      const std::string problem = pattern_problem(name);
      if (!problem.empty())
        fail(one, problem);
      else if (std::ranges::find(patterns, name) == patterns.end())
        patterns.push_back(name);
    };
    const toml::array* const list = node->as_array();
    if (list && list->empty()) fail(*node, "pattern is an empty list; name one value at least");
    if (list) {
      for (const toml::node& one : *list) add(one);
    } else {
      add(*node);
    }
    return patterns;
  }

  std::vector<double> whole_numbers(const toml::table& table, std::string_view key) {
    if (!table.contains(key)) return {0};
    std::vector<double> numbers = numbers_or(table, key, 1, subpixels_range.low, subpixels_range.high);
    for (const double number : numbers) {
      if (number != std::floor(number)) fail(*table.get(key), fmt::format("{} must be whole numbers", key));
    }
    return numbers;
  }

  void read_measure(const toml::table& measure) {
    check_keys(measure, "measure.", {"scale", "rounds", "seconds", "seed", "reference_subpixels"});
    PixelsSettings& s = config_.settings;
    s.scale = number_or(measure, "scale", s.scale, 0.01, 10);
    s.rounds = integer_or(measure, "rounds", s.rounds, 1, 10'000);
    s.seconds = number_or(measure, "seconds", s.seconds, 0, 3600);
    s.seed = static_cast<uint64_t>(integer_or(measure, "seed", 1, 0, 1 << 30));
    s.reference_subpixels = integer_or(measure, "reference_subpixels", sweeps_samples_ ? 1024 : 0,
                                       subpixels_range.low, subpixels_range.high);
  }

  PixelsConfig& config_;
  bool sweeps_samples_ = false;
};

}  // namespace

size_t PixelsConfig::cell_count() const {
  size_t count = 0;
  for (const PixelsGroup& group : groups) count += group.subjects.size();
  return count;
}

std::string group_key(const PixelsGroup& group) {
  return fmt::format("{}{}/{}", group.scene, group.offset == 0 ? "" : fmt::format("{:+g}", group.offset),
                     group.mode);
}

std::string cell_key(const PixelsGroup& group, const PixelsSubject& subject) {
  std::string key =
      fmt::format("{}/{}/{}/{}", group_key(group), subject.core, subject.method, subject.precision);
  if (!subject.pattern.empty()) key += '/' + subject.pattern;
  if (subject.subpixels > 0) key += fmt::format("/{}", subject.subpixels);
  return key;
}

bool is_pixels(const std::string& text, const std::string& file, const std::vector<std::string>& overrides) {
  return read_toml(text, file, overrides)["kind"].value<std::string>() == "pixels";
}

PixelsConfig parse_pixels_config(const std::string& text, const std::string& file,
                                 const std::vector<std::string>& overrides) {
  PixelsConfig config;
  config.file = file;
  config.text = text;
  const toml::table root = read_toml(text, file, overrides);
  if (!overrides.empty()) config.text = to_text(root);
  PixelsParser parser(config);
  parser.read(root);
  config.claims = read_claims(parser, root, {text, overrides}, claim_scope(config));
  parser.refuse_errors();
  return config;
}

nlohmann::json to_json(const PixelsConfig& config) {
  nlohmann::json json{{"experiment", config.settings.experiment},
                      {"title", config.title},
                      {"kind", "pixels"},
                      {"seed", config.settings.seed},
                      {"scale", config.settings.scale},
                      {"rounds", config.settings.rounds},
                      {"seconds", config.settings.seconds},
                      {"reference_subpixels", config.settings.reference_subpixels},
                      {"cells", nlohmann::json::array()},
                      {"left_out", config.left_out}};
  for (const PixelsGroup& group : config.groups) {
    for (const PixelsSubject& subject : group.subjects) json["cells"].push_back(cell_key(group, subject));
  }
  add_to_plan(json, config.claims.sheet);
  return json;
}

}  // namespace raysweep
