#include "results/tables/tables.h"

#include <nlohmann/json.hpp>

#include "results/hyper_threading.h"
#include "results/tables/frame_tables.h"
#include "results/tables/scaling_laws_tables.h"
#include "results/tables/table_files.h"
#include "results/tables/write_file.h"

namespace raysweep {

nlohmann::json rows_as_json(const Table& table) {
  auto list = nlohmann::json::array();
  for (const auto& cells : table.rows) {
    nlohmann::json row;
    for (size_t i = 0; i < cells.size(); ++i) row[table.columns[i].title] = cells[i];
    list.push_back(std::move(row));
  }
  return list;
}

nlohmann::json rows_as_json(const std::vector<CellRow>& rows, const NoiseFloor& floor) {
  return rows_as_json(scaling_data(rows, floor));
}

std::string tables_as_text(const std::vector<CellRow>& rows, const TableContext& context) {
  std::string text = to_text(scaling_table(rows, context));
  const auto add = [&](const Table& table) { text.append("\n").append(to_text(table)); };
  if (const auto schedule = schedule_table(rows)) add(*schedule);
  if (const auto groups = hyper_threading_groups(rows); !groups.empty())
    add(hyper_threading_table(rows, groups, context.floor));
  if (any_law(scaling_groups(rows))) add(scaling_laws_table(rows));
  if (!context.power.empty()) add(power_table(context.power));
  for (const ModeTable& made : mode_tables(rows)) add(made.table);
  return text;
}

std::vector<NamedTable> write_tables(const std::vector<CellRow>& rows, const TableContext& context,
                                     const std::filesystem::path& folder) {
  TableFolder files(folder);
  // What this report has nothing to say about must not stay from an earlier one.
  for (const char* name : {"laws", "schedule", "hyper-threading", "power"}) remove_table(folder, name);
  std::filesystem::remove(folder / "chunks.csv");
  files.write("scaling", scaling_table(rows, context), scaling_data(rows, context.floor));
  const auto frames = frame_times(rows);
  files.write("frames", frame_table(rows, frames), frame_data(rows, frames));
  if (!scaling_groups(rows).empty()) files.write("laws", scaling_laws_table(rows), scaling_laws_data(rows));
  if (const auto schedule = schedule_table(rows)) {
    files.write("schedule", *schedule, schedule_data(rows));
    write_file(folder / "chunks.csv", to_csv(chunk_data(rows)));
  }
  if (const auto groups = hyper_threading_groups(rows); !groups.empty()) {
    files.write("hyper-threading", hyper_threading_table(rows, groups, context.floor),
                hyper_threading_data(groups));
  }
  if (!context.power.empty()) files.write("power", power_table(context.power), power_data(context.power));
  for (const ModeTable& made : mode_tables(rows)) files.write(made.name, made.table);
  return files.tables();
}

}  // namespace raysweep
