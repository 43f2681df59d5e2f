// The tables of scaling laws: what keeps each group of cells from scaling.
#pragma once

#include <vector>

#include "results/scaling.h"
#include "results/statistics/scaling_laws.h"
#include "results/tables/table.h"

namespace raysweep {

/// Rows that are equal in all factors but threads, by rising threads; points into the rows that it was made
/// from.
struct ScalingGroup {
  std::vector<const CellRow*> rows;
  ScalingLaws laws;  // of the medians of fps
};

/// Groups with at least two thread counts that were measured.
[[nodiscard]] std::vector<ScalingGroup> scaling_groups(const std::vector<CellRow>& rows);

/// Whether a law could be fitted to any group.
[[nodiscard]] bool any_law(const std::vector<ScalingGroup>& groups);

/// For people: a row for each thread count; the laws, or why there are none, stand in a group's first row.
[[nodiscard]] Table scaling_laws_table(const std::vector<CellRow>& rows);

/// For programs: unrounded, every factor, a group's laws in each of its rows.
[[nodiscard]] Table scaling_laws_data(const std::vector<CellRow>& rows);

}  // namespace raysweep
