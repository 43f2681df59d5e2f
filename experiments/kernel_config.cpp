#include "experiments/kernel_config.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "experiments/claim_scopes.h"
#include "experiments/config_toml.h"
#include "experiments/intersection/protocols.h"
#include "experiments/intersection/run_subjects.h"
#include "experiments/read_claims.h"
#include "experiments/scheduled_pass.h"
#include "experiments/toml_reader.h"
#include "schedulers/registry.h"
#include "tracer/scene/scenes.h"

namespace raysweep {

namespace {

constexpr int most_threads = 1024;
constexpr std::string_view intersection = "intersection";
constexpr const char* without_early_outs = "early_out=no";

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

/// In the worst case every kernel takes part at 1, variants alone elsewhere.
std::vector<double> hit_rates_of(const Protocol& protocol, const KernelConfig& config) {
  if (protocol.name != "worst-case") return config.hit_rates;
  const bool has_others = config.variants.takes(without_early_outs);
  std::vector<double> rates = has_others ? config.hit_rates : std::vector<double>();
  add_once(rates, 1.0);
  return rates;
}

/// All lists of tests that a protocol has here.
std::vector<KernelTests> tests_of(const Protocol& protocol, const KernelConfig& config) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<KernelTests> list;
  if (protocol.has_scene) {
    for (const std::string& scene : config.scenes) list.push_back({&protocol, none, scene});
  } else if (protocol.has_hit_rate) {
    for (const double rate : hit_rates_of(protocol, config)) list.push_back({&protocol, rate, ""});
  } else if (protocol.has_size) {
    for (const double size : cluster_sizes()) list.push_back({&protocol, size, ""});
  } else {
    list.push_back({&protocol, none, ""});
  }
  return list;
}

/// Whether a kernel takes part. The worst case has only tests that do not end early: of any kernel where all
/// are hits, elsewhere of those that compute everything anyway.
template <class T>
bool takes_part(const Kernel<T>& kernel, const KernelTests& tests, const KernelConfig& config) {
  if (!config.variants.takes(kernel.change)) return false;
  if (tests.protocol->rays_a_visit % kernel.rays != 0) return false;
  return tests.protocol->name != "worst-case" || tests.parameter == 1 ||
         kernel.variant.early_out == EarlyOut::no;
}

/// Of a cell without its key.
std::string key_of(std::string_view method, const std::string& change, const KernelTests& tests,
                   const KernelCell& cell) {
  std::string key = fmt::format("{}/{}/{}/{}", method, change, name_of(cell.precision), tests.protocol->name);
  if (!std::isnan(tests.parameter)) key += fmt::format("/{:g}", tests.parameter);
  if (!tests.scene.empty()) key += '/' + tests.scene;
  if (cell.scheduler != own_shares) key += '/' + cell.scheduler;
  if (cell.threads > 1) key += fmt::format("/{} threads", cell.threads);
  return key;
}

template <class T>
void add_cells(KernelPlan& plan, const KernelConfig& config, Precision precision, size_t tests) {
  const auto& kernels = all_kernels<T>();
  for (const std::string& method : config.methods) {
    for (size_t i = 0; i < kernels.size(); ++i) {
      if (kernels[i].method != method || !takes_part(kernels[i], plan.tests[tests], config)) continue;
      for (const std::string& scheduler : config.schedulers) {
        for (const int threads : config.threads) {
          KernelCell cell{.precision = precision,
                          .kernel = i,
                          .tests = tests,
                          .threads = threads,
                          .scheduler = scheduler};
          cell.key = key_of(method, kernels[i].change, plan.tests[tests], cell);
          plan.cells.push_back(std::move(cell));
        }
      }
    }
  }
}

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

KernelPlan make_plan(const KernelConfig& config) {
  KernelPlan plan{.experiment = config.experiment,
                  .title = config.title,
                  .measure = config.measure,
                  .sheet = config.claims.sheet};
  for (const SmallKernelSweep& sweep : config.small) {
    for (SmallKernelCell& cell : cells_of(sweep, plan.left_out))
      plan.cells.push_back(
          {.key = std::move(cell.key), .small = sweep.kernel, .values = std::move(cell.values)});
  }
  for (const std::string& name : config.protocols) {
    for (const KernelTests& tests : tests_of(*find_protocol(name), config)) plan.tests.push_back(tests);
  }
  for (size_t tests = 0; tests < plan.tests.size(); ++tests) {
    for (const Precision precision : config.precisions) {
      if (precision == Precision::float_precision)
        add_cells<float>(plan, config, precision, tests);
      else
        add_cells<double>(plan, config, precision, tests);
    }
  }
  plan.wall_clock = std::ranges::any_of(
      plan.cells, [](const KernelCell& cell) { return cell.threads > 1 || cell.scheduler != own_shares; });
  std::vector<std::string_view> precisions;
  for (const Precision precision : config.precisions) precisions.push_back(name_of(precision));
  plan.left_out = left_out_of(inapplicable_here(), config.variants, config.methods, precisions);
  return plan;
}

size_t record_count(const KernelPlan& plan) {
  return plan.cells.size() * static_cast<size_t>(plan.measure.rounds);
}

nlohmann::json to_json(const KernelPlan& plan) {
  nlohmann::json json{{"experiment", plan.experiment},
                      {"title", plan.title},
                      {"kind", "kernel"},
                      {"seed", plan.measure.seed},
                      {"rounds", plan.measure.rounds},
                      {"samples", plan.measure.samples},
                      {"min_seconds", plan.measure.min_seconds},
                      {"cells", nlohmann::json::array()},
                      {"left_out", nlohmann::json::array()}};
  for (const KernelCell& cell : plan.cells) json["cells"].push_back(cell.key);
  for (const Inapplicable& one : plan.left_out) {
    json["left_out"].push_back({{"method", one.method},
                                {"change", one.change},
                                {"precision", one.precision},
                                {"reason", one.reason}});
  }
  add_to_plan(json, plan.sheet);
  return json;
}

}  // namespace raysweep
