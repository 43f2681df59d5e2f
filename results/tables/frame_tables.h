// The tables of frame times.
#pragma once

#include <optional>
#include <vector>

#include "results/frame_times.h"
#include "results/scaling.h"
#include "results/tables/table.h"

namespace raysweep {

/// Those of each row, in their order; none for rows without a valid launch. The bootstrap takes a while: once
/// for both tables.
[[nodiscard]] std::vector<std::optional<FrameTimes>> frame_times(const std::vector<CellRow>& rows);

/// For people: milliseconds, one row a cell.
[[nodiscard]] Table frame_table(const std::vector<CellRow>& rows,
                                const std::vector<std::optional<FrameTimes>>& times);

/// For programs: seconds, unrounded, every factor.
[[nodiscard]] Table frame_data(const std::vector<CellRow>& rows,
                               const std::vector<std::optional<FrameTimes>>& times);

}  // namespace raysweep
