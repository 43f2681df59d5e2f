// An experiment of the kind "accuracy" as its file states it, and what it asks for.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "experiments/claims_config.h"
#include "experiments/intersection/accuracy.h"
#include "experiments/intersection/run_subjects.h"
#include "experiments/variant_choice.h"

namespace raysweep {

struct AccuracyConfig {
  std::string file, text;  // text as run: with what --set changed
  std::string title;
  AccuracySettings settings;
  std::vector<std::string> methods, cases;  // names, as listed
  std::vector<Precision> precisions;
  VariantChoice variants;
  int threads = 0;  // 0: as many as there are processors that this process may use
  ClaimsConfig claims;
};

/// Whether a config is of this kind. Throws RequestError for what is no TOML.
[[nodiscard]] bool is_accuracy(const std::string& text, const std::string& file,
                               const std::vector<std::string>& overrides);

/// As `parse_config` does for pictures. Without [sweep]: all methods, cases and precisions in base variants.
/// Throws RequestError with one line per error.
[[nodiscard]] AccuracyConfig parse_accuracy_config(const std::string& text, const std::string& file,
                                                   const std::vector<std::string>& overrides);

/// All cells, by what is tried on the same trials.
struct AccuracyPlan {
  std::string title;
  AccuracySettings settings;
  size_t threads;  // to run batches on, which changes no record
  ClaimSheet sheet;
  std::vector<AccuracyBatch> batches;
  std::vector<Inapplicable> left_out;  // variants that were asked for, which their methods do not have

  [[nodiscard]] size_t cell_count() const;
};

/// Throws std::system_error if threads are not given and the system does not tell its processors.
[[nodiscard]] AccuracyPlan make_plan(const AccuracyConfig& config);

/// plan.json: the key of every cell, in order; what is left out and why; the seed. Not the threads: a run may
/// be taken up on others.
[[nodiscard]] nlohmann::json to_json(const AccuracyPlan& plan);

}  // namespace raysweep
