// report.json: all that a page about a run needs beside its records.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "results/judged_run.h"
#include "results/tables/table.h"

namespace raysweep {

inline constexpr int report_schema = 1;

/// Rows with every value and interval, the samples of what was timed, claims with each group's number beside
/// what is expected, printed numbers beside ours, and the tables that people read.
[[nodiscard]] nlohmann::json report_as_json(const JudgedRun& report, const std::vector<NamedTable>& tables);

/// The claims alone.
[[nodiscard]] nlohmann::json claims_as_json(const std::vector<ClaimJudgement>& claims);

}  // namespace raysweep
