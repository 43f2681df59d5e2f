// What verbs do with pixels experiments.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "experiments/pixels_run.h"

namespace raysweep {

// Each of these prints for people, or, where `json` is not null, appends its document there instead.

/// Runs, then tells with tables; writes these into the folder. The exit code.
[[nodiscard]] int run_and_tell(const PixelsExperiment& experiment, nlohmann::json* json);

/// What would be run, and how long its frames would be timed.
void dry_run_pixels(const PixelsConfig& config, nlohmann::json* json);

/// The tables of a folder anew, judged by `claims`, or those of its plan. Throws RecordError where it cannot
/// be read.
void report_pixels(const std::filesystem::path& folder, nlohmann::json* json,
                   const std::optional<ClaimSheet>& claims);

}  // namespace raysweep
