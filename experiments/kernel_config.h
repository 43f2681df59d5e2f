// An experiment of the kind "kernel" as its file states it.
#pragma once

#include <string>
#include <vector>

#include "experiments/claims_config.h"
#include "experiments/intersection/accuracy.h"
#include "experiments/intersection/subjects.h"
#include "experiments/small_kernel_sweep.h"
#include "experiments/variant_choice.h"

namespace raysweep {

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

}  // namespace raysweep
