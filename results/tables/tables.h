// The tables of a run.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "results/noise_floor.h"
#include "results/power.h"
#include "results/scaling.h"
#include "results/tables/table.h"

namespace raysweep {

/// What a reader needs to know beside the numbers.
struct TableContext {
  std::string experiment, title;
  NoiseFloor floor{};
  std::vector<Power> power{};  // of runs that plant slowdowns to learn what comparisons find
};

/// For people: one row a cell; factors that never change stand in the caption, not in columns, and so does
/// the noise floor. The column `against the best` is left out where no two cells render the same picture with
/// as many threads.
[[nodiscard]] Table scaling_table(const std::vector<CellRow>& rows, const TableContext& context);

/// For programs: one row a cell, every factor and every number unrounded, intervals in columns of their own.
[[nodiscard]] Table scaling_data(const std::vector<CellRow>& rows, const NoiseFloor& floor = {});

/// The same as one JSON object a row, keyed by column.
[[nodiscard]] nlohmann::json rows_as_json(const std::vector<CellRow>& rows, const NoiseFloor& floor = {});

/// Any table as one JSON object a row.
[[nodiscard]] nlohmann::json rows_as_json(const Table& table);

/// Where the time of each cell went: its rows are those of the scaling table. Columns for which no row has a
/// value are left out; none if no row has any.
[[nodiscard]] std::optional<Table> schedule_table(const std::vector<CellRow>& rows);

/// The same unrounded, with every factor and every interval.
[[nodiscard]] Table schedule_data(const std::vector<CellRow>& rows);

/// How many chunks of which size a frame had: one row a cell and size.
[[nodiscard]] Table chunk_data(const std::vector<CellRow>& rows);

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

/// Writes `scaling`, `frames`, `laws`, `schedule`, `hyper-threading` and the mode tables, as .md, .tex (LaTeX
/// with booktabs) and .csv, and `chunks.csv`, into `folder`, which is made; of what a run has nothing to say
/// about there is no file. Those that people read.
std::vector<NamedTable> write_tables(const std::vector<CellRow>& rows, const TableContext& context,
                                     const std::filesystem::path& folder);

}  // namespace raysweep
