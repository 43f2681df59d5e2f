// The tables of a run.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "results/scaling.h"
#include "results/table.h"

namespace raysweep {

/// What a reader needs to know beside the numbers.
struct TableContext {
  std::string experiment, title;
};

/// For people: one row a cell; factors that never change stand in the caption, not in columns.
[[nodiscard]] Table scaling_table(const std::vector<CellRow>& rows, const TableContext& context);

/// For programs: one row a cell, every factor and every number unrounded, intervals in columns of their own.
[[nodiscard]] Table scaling_data(const std::vector<CellRow>& rows);

/// The same as one JSON object a row, keyed by column.
[[nodiscard]] nlohmann::json rows_as_json(const std::vector<CellRow>& rows);

/// A number against threads and modes: the layout of Morozov 2011's tables 3 and 4.
struct ModeTable {
  std::string name;  // for a file: "fps-omp_static"
  Table table;
};

/// fps and speedup, threads × modes, one pair a scheduler (and other varying factors); none where a run has
/// one mode.
[[nodiscard]] std::vector<ModeTable> mode_tables(const std::vector<CellRow>& rows);

/// Everything a terminal should show.
[[nodiscard]] std::string tables_as_text(const std::vector<CellRow>& rows, const TableContext& context);

/// Writes `scaling.md`, `scaling.csv` and the mode tables, as .md and .csv, into `folder`, which is made.
void write_tables(const std::vector<CellRow>& rows, const TableContext& context,
                  const std::filesystem::path& folder);

}  // namespace raysweep
