#include "experiments/kernel_config.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/claim_scopes.h"
#include "experiments/config_toml.h"
#include "experiments/intersection/protocols.h"
#include "experiments/intersection/run_subjects.h"
#include "experiments/read_claims.h"
#include "experiments/scheduled_pass.h"
#include "experiments/toml_reader.h"
#include "results/kernel_record.h"
#include "schedulers/registry.h"
#include "tracer/scene/scenes.h"

namespace raysweep {

namespace {

constexpr int most_threads = 1024;
constexpr std::string_view intersection = "intersection";

std::vector<std::string_view> protocol_names() {
  std::vector<std::string_view> names;
  for (const Protocol& protocol : all_protocols()) names.push_back(protocol.name);
  return names;
}

std::vector<std::string_view> scenes_with_triangles() {
  std::vector<std::string_view> names;
  for (const BuiltInScene& scene : built_in_scenes()) {
    if (scene.triangle_count > 0) names.push_back(scene.name);
  }
  return names;
}

template <class Value>
void add_once(std::vector<Value>& list, const Value& value) {
  if (std::find(list.begin(), list.end(), value) == list.end()) list.push_back(value);
}

class KernelParser : public TomlReader {
 public:
  KernelParser(KernelConfig& config, int processors)
      : TomlReader(config.file), config_(config), processors_(processors) {}

  void read(const toml::table& root) {
    const ConfigHead of_all = head(root, {"sweep", "measure"});
    config_.experiment = of_all.experiment;
    config_.title = of_all.title;
    const toml::table none;
    const toml::table* const sweep = section(root, "sweep");
    read_sweep(sweep ? *sweep : none);
    const toml::table* const measure = section(root, "measure");
    read_measure(measure ? *measure : none);
  }

 private:
  void read_sweep(const toml::table& sweep) {
    const auto kernels = kernel_names(sweep);
    if (kernels.front() != intersection) {
      config_.small = read_small_kernels(*this, sweep, kernels);
      return;
    }
    check_keys(sweep, "sweep.",
               {"kernel", "method", "protocol", "hit_rate", "precision", "variants", "scene", "scheduler",
                "threads"});
    config_.methods = names(sweep, "method", study_method_names(), "all");
    config_.protocols = names(sweep, "protocol", protocol_names(), "random");
    config_.scenes = names(sweep, "scene", scenes_with_triangles(), "chair-ball");
    for (const std::string& name : names(sweep, "precision", {"float", "double"}, "all"))
      config_.precisions.push_back(name == "float" ? Precision::float_precision
                                                   : Precision::double_precision);
    config_.variants =
        read_variants(*this, sweep, "variants",
                      changes_of(all_kernels<float>(), all_kernels<double>(), inapplicable_here()));
    read_hit_rates(sweep);
    read_threads(sweep);
    read_schedulers(sweep);
  }

  /// Of "all" those that are available here.
  void read_schedulers(const toml::table& sweep) {
    std::vector<std::string_view> known = kernel_schedulers();
    known.insert(known.begin(), own_shares);
    const bool are_all = sweep["scheduler"].value<std::string>() == "all";
    for (const std::string& name : names(sweep, "scheduler", known, own_shares)) {
      const std::string problem = name == own_shares ? "" : why_unavailable(*find_scheduler(name));
      if (problem.empty())
        config_.schedulers.push_back(name);
      else if (!are_all)
        fail(*sweep.get("scheduler"),
             fmt::format("scheduler \"{}\" cannot be used here: it is {}", name, problem));
    }
  }

  /// Intersection alone, or others.
  std::vector<std::string> kernel_names(const toml::table& sweep) {
    std::vector<std::string_view> known{intersection};
    for (const SmallKernel& kernel : all_small_kernels()) known.push_back(kernel.name);
    std::vector<std::string> list;
    for_each(sweep, "kernel", [&](const toml::node& one) {
      const std::string name = one.value_exact<std::string>().value_or("");
      if (std::ranges::find(known, name) == known.end())
        fail(one, fmt::format("unknown kernel \"{}\"; built here: {}", name, fmt::join(known, ", ")));
      else
        add_once(list, name);
    });
    if (list.size() > 1 && std::ranges::find(list, intersection) != list.end())
      fail(*sweep.get("kernel"), "kernel \"intersection\" is an experiment of its own; name it alone");
    if (list.empty()) list.emplace_back(intersection);
    return list;
  }

  void read_measure(const toml::table& measure) {
    check_keys(measure, "measure.", {"rounds", "samples", "min_time", "budget", "seed"});
    config_.measure.rounds = integer_or(measure, "rounds", 9, 1, 1000);
    config_.measure.samples = integer_or(measure, "samples", 3, 1, 1000);
    config_.measure.min_seconds = number_or(measure, "min_time", 0.005, 1e-6, 60);
    config_.measure.budget_seconds = duration_or(measure, "budget", 20 * 60);
    config_.measure.seed = static_cast<uint64_t>(integer_or(measure, "seed", 1, 0, 1 << 30));
  }

  void read_hit_rates(const toml::table& sweep) {
    for_each(sweep, "hit_rate", [&](const toml::node& one) {
      const auto rate = one.is_number() ? one.value<double>() : std::nullopt;
      const double steps = rate.value_or(-1) * run_length;
      if (!(steps >= 0 && steps <= run_length && std::abs(steps - std::round(steps)) < 1e-9))
        fail(one, fmt::format("hit_rate must be numbers from 0 to 1 in steps of {}", 1.0 / run_length));
      else
        add_once(config_.hit_rates, *rate);
    });
    if (!sweep.contains("hit_rate")) config_.hit_rates = {0.5};
  }

  void read_threads(const toml::table& sweep) {
    for_each(sweep, "threads", [&](const toml::node& one) {
      const auto count = one.value_exact<int64_t>();
      if (one.value_exact<std::string>() == "all")
        add_once(config_.threads, processors_);
      else if (count && *count >= 1 && *count <= most_threads)
        add_once(config_.threads, static_cast<int>(*count));
      else
        fail(one, fmt::format("threads must be whole numbers from 1 to {}, or \"all\"", most_threads));
    });
    if (!sweep.contains("threads")) config_.threads = {1};
  }

  /// Shows `each` the value of a key or those of its list, which must not be empty.
  template <class Each>
  void for_each(const toml::table& table, std::string_view key, Each&& each) {
    const toml::node* const node = table.get(key);
    if (!node) return;
    const toml::array* const list = node->as_array();
    if (!list) return each(*node);
    if (list->empty()) fail(*node, fmt::format("{} is an empty list; name one value at least", key));
    for (const toml::node& one : *list) each(one);
  }

  /// Names of `known`, each once; "all" are all of them. Without the key what `otherwise` stands for.
  std::vector<std::string> names(const toml::table& table, std::string_view key,
                                 const std::vector<std::string_view>& known, const std::string& otherwise) {
    std::vector<std::string> list;
    const auto add = [&](const std::string& name) {
      for (const std::string_view each : known) {
        if (name == "all" || name == each) add_once(list, std::string(each));
      }
    };
    if (!table.contains(key)) add(otherwise);
    for_each(table, key, [&](const toml::node& one) {
      const auto name = one.value_exact<std::string>();
      if (!name) {
        fail(one, fmt::format("{} must be strings in quotes", key));
      } else if (*name != "all" && std::find(known.begin(), known.end(), *name) == known.end()) {
        fail(one, fmt::format("unknown {} \"{}\"; built here: {}, all", key, *name, fmt::join(known, ", ")));
      } else {
        add(*name);
      }
    });
    return list;
  }

  KernelConfig& config_;
  int processors_;
};

}  // namespace

bool is_kernel(const std::string& text, const std::string& file, const std::vector<std::string>& overrides) {
  return read_toml(text, file, overrides)["kind"].value<std::string>() == "kernel";
}

KernelConfig parse_kernel_config(const std::string& text, const std::string& file,
                                 const std::vector<std::string>& overrides, int processors) {
  KernelConfig config;
  config.file = file;
  config.text = text;
  const toml::table root = read_toml(text, file, overrides);
  if (!overrides.empty()) config.text = to_text(root);
  KernelParser parser(config, processors);
  parser.read(root);
  config.claims = read_claims(parser, root, {text, overrides}, claim_scope(config));
  parser.refuse_errors();
  return config;
}

}  // namespace raysweep
