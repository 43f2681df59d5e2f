#include "experiments/config.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "experiments/cell_factors.h"
#include "experiments/claim_scopes.h"
#include "experiments/config_toml.h"
#include "experiments/errors.h"
#include "experiments/read_claims.h"
#include "experiments/toml_reader.h"
#include "tracer/scene/scenes.h"

namespace raysweep {

namespace {

/// Walks a TOML document, collecting a Config and every error on the way.
class PictureParser : public TomlReader {
 public:
  PictureParser(Config& config, const MachineSize& machine)
      : TomlReader(config.file), config_(config), machine_(machine) {}

  void read(const toml::table& root) {
    const ConfigHead of_all = head(root, {"scene", "sweep", "measure"});
    config_.experiment = of_all.experiment;
    config_.title = of_all.title;
    if (const std::string kind = text_or(root, "kind", "picture"); kind != "picture") {
      fail(root["kind"],
           fmt::format("unknown kind \"{}\"; built here: picture, accuracy, kernel, pixels", kind));
    }
    if (const auto* scene = section(root, "scene")) read_scene(*scene);
    if (const auto* sweep = section(root, "sweep")) read_sweep(*sweep);
    if (const auto* measure = section(root, "measure")) read_measure(*measure);
  }

 private:
  void read_scene(const toml::table& scene) {
    check_keys(scene, "scene.", {"name", "file", "modes"});
    if (scene.contains("name") && scene.contains("file"))
      fail(scene, "a scene has a name or a file, not both");
    config_.scene = text_or(scene, "name", config_.scene);
    if (scene.contains("file")) {
      config_.scene =
          (std::filesystem::path(config_.file).parent_path() / text_or(scene, "file", "")).string();
    }
    try {
      (void)load_scene(config_.scene);
    } catch (const SceneError& error) {
      fail(scene, error.what());
    }
    if (const toml::node* const modes = scene.get("modes")) {
      for (const Value& value : values_of(*modes, "modes", false)) {
        Cell scratch;
        try {
          set_mode(scratch, value.text);
          config_.modes.push_back(value.text);
        } catch (const RequestError& error) {
          fail(*value.node, error.what());
        }
      }
    }
  }

  void read_sweep(const toml::table& sweep) {
    for (const auto& [key, node] : sweep) {
      if (key == "zip") {
        if (node.is_table()) {
          read_zip(*node.as_table());
        } else {
          fail(node, "\"zip\" must be a table: [sweep.zip]");
        }
      } else if (key == "placement") {
        read_placement(sweep, node);
      } else {
        SweepAxis axis{{std::string(key.str())}, {}};
        for (std::string& value : factor_values(key.str(), node)) axis.points.push_back({std::move(value)});
        if (!axis.points.empty()) config_.axes.push_back(std::move(axis));
      }
    }
  }

  /// `placement = "hyper-threading"`: threads and pin together, as many threads as cores, on as many or half
  /// as many, and twice as many.
  void read_placement(const toml::table& sweep, const toml::node& node) {
    if (node.value_exact<std::string>() != "hyper-threading") {
      fail(node, "unknown placement; possible: \"hyper-threading\"");
      return;
    }
    for (const char* name : {"threads", "pin"}) {
      if (sweep.contains(name))
        fail(*sweep.get(name), fmt::format("placement decides \"{}\" too; keep one of them", name));
    }
    if (!machine_.hyper_threading) {
      config_.not_here = fmt::format(
          "this machine shows no hyper-threading ({} cores, {} processors): every hardware thread is a core "
          "of its own, so there is nothing to compare",
          machine_.cores, machine_.pus);
      return;
    }
    const HyperThreadingPlacements& p = *machine_.hyper_threading;
    SweepAxis axis{{"threads", "pin"}, {}};
    for (const std::vector<int>* placed : {&p.one_each, &p.two_each, &p.packed}) {
      if (!placed->empty()) axis.points.push_back({std::to_string(placed->size()), processor_list(*placed)});
    }
    config_.axes.push_back(std::move(axis));
  }

  void read_zip(const toml::table& zip) {
    SweepAxis axis;
    for (const auto& [key, node] : zip) {
      const auto values = factor_values(key.str(), node);
      if (axis.names.empty()) axis.points.resize(values.size());
      if (values.size() != axis.points.size()) {
        fail(node, fmt::format("lists in [sweep.zip] advance together: \"{}\" has {} values, \"{}\" has {}",
                               key.str(), values.size(), axis.names.front(), axis.points.size()));
        return;
      }
      axis.names.emplace_back(key.str());
      for (size_t i = 0; i < values.size(); ++i) axis.points[i].push_back(values[i]);
    }
    for (const SweepAxis& other : config_.axes) {
      for (const std::string& name : other.names) {
        const toml::node* const twice = zip.get(name);
        if (twice)
          fail(*twice, fmt::format("\"{}\" stands in [sweep] and in [sweep.zip]; keep one of them", name));
      }
    }
    if (!axis.names.empty()) config_.axes.push_back(std::move(axis));
  }

  struct Value {
    std::string text;
    const toml::node* node;
  };

  /// A value or a list of values as text; ranges of factors that are numbers expanded.
  std::vector<Value> values_of(const toml::node& node, std::string_view name, bool numeric) {
    std::vector<Value> values;
    const auto add = [&](const toml::node& one) {
      if (const auto number = one.value_exact<int64_t>(); number && numeric) {
        values.push_back({std::to_string(*number), &one});
      } else if (const auto real = one.value_exact<double>(); real && numeric) {
        values.push_back({fmt::format("{}", *real), &one});
      } else if (const auto text = one.value_exact<std::string>()) {
        for (std::string& value : expand_value(*text, name, numeric, machine_))
          values.push_back({std::move(value), &one});
      } else {
        fail(one,
             numeric
                 ? fmt::format("{} must be numbers or ranges such as \"1..4\", \"cores\", \"1..2*pus\"", name)
                 : fmt::format("{} must be strings in quotes", name));
      }
    };
    if (const toml::array* const list = node.as_array()) {
      if (list->empty()) fail(node, fmt::format("{} is an empty list; name one value at least", name));
      for (const toml::node& one : *list) add(one);
    } else {
      add(node);
    }
    return values;
  }

  /// The values that a sweep gives a factor, each checked.
  std::vector<std::string> factor_values(std::string_view name, const toml::node& node) {
    const CellFactor* const factor = find_factor(name);
    if (!factor || name == "scene") {
      std::vector<std::string_view> known;
      for (const CellFactor& f : cell_factors()) {
        if (f.name != "scene") known.push_back(f.name);
      }
      fail(node, fmt::format("unknown key \"sweep.{}\"; possible: {}, placement, zip", name,
                             fmt::join(known, ", ")));
      return {};
    }
    std::vector<std::string> checked;
    for (Value& value : values_of(node, name, factor->numeric)) {
      Cell scratch;
      std::string problem = factor->set(scratch, value.text);
      if (problem.empty() && name == "pin") problem = pin_problem(value.text, machine_.processors);
      if (!problem.empty()) {
        fail(*value.node, name == "isa" ? problem + ", all" : problem);
      } else {
        checked.push_back(std::move(value.text));
      }
    }
    return checked;
  }

  void read_measure(const toml::table& measure) {
    check_keys(
        measure, "measure.",
        {"launches", "max_launches", "twins", "bases", "budget", "interval", "seconds", "timeout", "seed"});
    Measure& m = config_.measure;
    m.launches = integer_or(measure, "launches", m.launches, 1, 10000);
    // Without an interval there is nothing that could converge.
    const int usual = m.launches < 6 ? m.launches : std::min(4 * m.launches, 10000);
    m.max_launches = integer_or(measure, "max_launches", usual, m.launches, 10000);
    m.twins = integer_or(measure, "twins", m.twins, 0, 16);
    m.bases = truth_or(measure, "bases", m.bases);
    m.interval = number_or(measure, "interval", m.interval, 1e-4, 1);
    m.seconds = number_or(measure, "seconds", m.seconds, 0, 3600);
    m.seed = static_cast<uint64_t>(integer_or(measure, "seed", static_cast<int>(m.seed), 0, 1 << 30));
    m.budget_seconds = duration_or(measure, "budget", m.budget_seconds);
    m.timeout_seconds = duration_or(measure, "timeout", m.timeout_seconds);
  }

  Config& config_;
  const MachineSize machine_;
};

}  // namespace

Config parse_config(const std::string& text, const std::string& file,
                    const std::vector<std::string>& overrides, const MachineSize& machine) {
  Config config;
  config.file = file;
  config.text = text;
  const toml::table root = read_toml(text, file, overrides);
  if (!overrides.empty()) config.text = to_text(root);
  PictureParser parser(config, machine);
  parser.read(root);
  config.claims = read_claims(parser, root, {text, overrides}, claim_scope(config));
  parser.refuse_errors();
  return config;
}

std::string read_config_text(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  if (!std::filesystem::is_regular_file(file) || !in || !(text << in.rdbuf())) {
    throw RequestError(fmt::format(
        "{}: no such experiment: name a TOML file; `raysweep list experiments` shows those here", file));
  }
  return text.str();
}

}  // namespace raysweep
