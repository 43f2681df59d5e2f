// An experiment of the kind "kernel" as its file states it, and what it asks for.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "experiments/claims_config.h"
#include "experiments/intersection/accuracy.h"
#include "experiments/intersection/subjects.h"
#include "experiments/small_kernel_sweep.h"
#include "experiments/variant_choice.h"
#include "results/kernel_record.h"

namespace raysweep {

struct Protocol;

/// How kernels are timed.
struct KernelMeasure {
  int rounds = 0;          // each cell once in each, in an order of its own
  int samples = 0;         // of a cell in a round
  double min_seconds = 0;  // a sample
  double budget_seconds = 0;
  uint64_t seed = 0;  // of the tests, and of the order
};

struct KernelConfig {
  std::string file, text;  // text as run: with what --set changed
  std::string experiment, title;
  std::vector<SmallKernelSweep> small;                  // empty: intersection, by what follows
  std::vector<std::string> methods, protocols, scenes;  // names, as listed
  std::vector<double> hit_rates;
  std::vector<Precision> precisions;
  std::vector<int> threads;
  std::vector<std::string> schedulers;  // names, or `own_shares`
  VariantChoice variants;
  KernelMeasure measure;
  ClaimsConfig claims;
};

/// Whether a config is of this kind. Throws RequestError for what is no TOML.
[[nodiscard]] bool is_kernel(const std::string& text, const std::string& file,
                             const std::vector<std::string>& overrides);

/// As `parse_config` does for pictures; `processors` are what "all" threads are. Throws RequestError with one
/// line per error.
[[nodiscard]] KernelConfig parse_kernel_config(const std::string& text, const std::string& file,
                                               const std::vector<std::string>& overrides, int processors);

/// A list of tests. All cells that name it do the same.
struct KernelTests {
  const Protocol* protocol = nullptr;
  double parameter;   // NaN where the protocol has none
  std::string scene;  // empty where the protocol has none
};

/// A kernel of intersection on a list of tests; or, where `small` is not null, that one with its values.
struct KernelCell {
  Precision precision{};
  size_t kernel = 0;  // index of `all_kernels` of that precision
  size_t tests = 0;   // index of the plan's
  int threads = 1;
  std::string scheduler = own_shares;
  // "wald/division=late/float/hit-rate/0.3"; with a scheduler or more than one thread "…/tbb_auto/2 threads".
  std::string key{};
  const SmallKernel* small = nullptr;
  FactorValues values{};
};

struct KernelPlan {
  std::string experiment, title;
  KernelMeasure measure;
  ClaimSheet sheet;
  std::vector<KernelTests> tests{};
  std::vector<KernelCell> cells{};
  bool wall_clock = false;               // for all cells, where any has several threads or a scheduler
  std::vector<Inapplicable> left_out{};  // variants that were asked for, which their methods do not have
};

[[nodiscard]] KernelPlan make_plan(const KernelConfig& config);

/// Of all rounds.
[[nodiscard]] size_t record_count(const KernelPlan& plan);

/// plan.json: the key of every cell, in order; what is left out and why; how it is measured.
[[nodiscard]] nlohmann::json to_json(const KernelPlan& plan);

}  // namespace raysweep
