// plan.json of a run's folder, of whatever kind.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "results/record.h"

namespace raysweep {

/// Throws RecordError where there is none, or no JSON object in it.
[[nodiscard]] nlohmann::json read_plan_file(const std::filesystem::path& folder);

/// What to throw where something is missing in it.
[[nodiscard]] RecordError not_a_plan(const std::filesystem::path& folder, const std::string& reason);

}  // namespace raysweep
