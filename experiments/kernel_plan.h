// What an experiment of the kind "kernel" asks for: its cells.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "experiments/kernel_config.h"
#include "results/kernel_record.h"

namespace raysweep {

struct Protocol;

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
