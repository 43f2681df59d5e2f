#include "experiments/kernel_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "experiments/intersection/protocols.h"
#include "experiments/intersection/run_subjects.h"

namespace raysweep {

namespace {

constexpr const char* without_early_outs = "early_out=no";

/// In the worst case every kernel takes part at 1, variants alone elsewhere.
std::vector<double> hit_rates_of(const Protocol& protocol, const KernelConfig& config) {
  if (protocol.name != "worst-case") return config.hit_rates;
  const bool has_others = config.variants.takes(without_early_outs);
  std::vector<double> rates = has_others ? config.hit_rates : std::vector<double>();
  if (std::ranges::find(rates, 1.0) == rates.end()) rates.push_back(1.0);
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
  if (!config.variants.takes(kernel.change, kernel.combines)) return false;
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
  plan.left_out = left_out_of(inapplicable_here(), config.variants, config.methods, config.precisions);
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
                      {"left_out", left_out_as_json(plan.left_out)}};
  for (const KernelCell& cell : plan.cells) json["cells"].push_back(cell.key);
  add_to_plan(json, plan.sheet);
  return json;
}

}  // namespace raysweep
