// The tables of a pixels experiment: pure functions of what was recorded.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "results/pixels_results.h"
#include "results/tables/table.h"

namespace raysweep {

/// Wrong pixels in colour with FLIP beside the nanoseconds of a ray: one row a cell that has its reference's
/// samples, so that only rounding tells them apart.
[[nodiscard]] Table pixels_table(const std::vector<PixelsRow>& rows);

/// Of those rows whose reference has other samples than they: how far they are from it, everywhere and at
/// edges.
[[nodiscard]] Table sampling_table(const std::vector<PixelsRow>& rows);

/// For programs: one row a cell, every number unrounded.
[[nodiscard]] Table pixels_data(const std::vector<PixelsRow>& rows);

/// What a terminal should show.
[[nodiscard]] std::string pixels_tables_as_text(const PixelsData& data);

/// Writes the tables pixels and sampling, where they have rows, and cells.csv into `folder`, which is made.
/// Those that people read.
std::vector<NamedTable> write_pixels_tables(const PixelsData& data, const std::filesystem::path& folder);

}  // namespace raysweep
