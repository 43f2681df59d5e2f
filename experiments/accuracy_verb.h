// What verbs do with accuracy experiments.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "experiments/accuracy_run.h"

namespace raysweep {

// Each of these prints for people, or, where `json` is not null, appends its document there instead.

/// Runs, then tells with tables; writes these into the folder. The exit code.
[[nodiscard]] int run_and_tell(const AccuracyExperiment& experiment, nlohmann::json* json);

/// What would be run, and how long it might take.
void dry_run_accuracy(const AccuracyConfig& config, nlohmann::json* json);

/// The tables of a folder anew, judged by `claims`, or those of its plan. Throws RecordError where it cannot
/// be read.
void report_accuracy(const std::filesystem::path& folder, nlohmann::json* json,
                     const std::optional<ClaimSheet>& claims);

}  // namespace raysweep
