// Verdicts, and printed numbers beside ours, as tables.
#pragma once

#include <string>
#include <vector>

#include "results/claims/judge.h"
#include "results/claims/published_rows.h"
#include "results/tables/table.h"

namespace raysweep {

/// For people: one row a claim, with what was found in the source and here, and why.
[[nodiscard]] Table claims_table(const std::vector<ClaimJudgement>& claims);

/// For programs: one row a claim, side and group, every number unrounded.
[[nodiscard]] Table claims_data(const std::vector<ClaimJudgement>& claims);

/// For people: factors that never change stand in the caption.
[[nodiscard]] Table published_table(const PublishedTable& table, const std::vector<PublishedRow>& rows);

/// The same unrounded, with every factor and every interval.
[[nodiscard]] Table published_data(const std::vector<PublishedRow>& rows);

/// For a terminal: a few lines a claim.
[[nodiscard]] std::string claims_as_text(const std::vector<ClaimJudgement>& claims);

}  // namespace raysweep
