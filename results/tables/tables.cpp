#include "results/tables/tables.h"

#include <nlohmann/json.hpp>

#include "results/hyper_threading.h"
#include "results/tables/frame_tables.h"
#include "results/tables/scaling_laws_tables.h"
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

void write_tables(const std::vector<CellRow>& rows, const TableContext& context,
                  const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  // What this report has nothing to say about must not stay from an earlier one.
  for (const char* name : {"laws", "schedule", "chunks", "hyper-threading", "power"}) {
    for (const char* suffix : {".md", ".csv"}) std::filesystem::remove(folder / (std::string(name) + suffix));
  }
  write_file(folder / "scaling.md", to_markdown(scaling_table(rows, context)));
  write_file(folder / "scaling.csv", to_csv(scaling_data(rows, context.floor)));
  const auto frames = frame_times(rows);
  write_file(folder / "frames.md", to_markdown(frame_table(rows, frames)));
  write_file(folder / "frames.csv", to_csv(frame_data(rows, frames)));
  if (!scaling_groups(rows).empty()) {
    write_file(folder / "laws.md", to_markdown(scaling_laws_table(rows)));
    write_file(folder / "laws.csv", to_csv(scaling_laws_data(rows)));
  }
  if (const auto schedule = schedule_table(rows)) {
    write_file(folder / "schedule.md", to_markdown(*schedule));
    write_file(folder / "schedule.csv", to_csv(schedule_data(rows)));
    write_file(folder / "chunks.csv", to_csv(chunk_data(rows)));
  }
  if (const auto groups = hyper_threading_groups(rows); !groups.empty()) {
    write_file(folder / "hyper-threading.md",
               to_markdown(hyper_threading_table(rows, groups, context.floor)));
    write_file(folder / "hyper-threading.csv", to_csv(hyper_threading_data(groups)));
  }
  if (!context.power.empty()) {
    write_file(folder / "power.md", to_markdown(power_table(context.power)));
    write_file(folder / "power.csv", to_csv(power_data(context.power)));
  }
  for (const ModeTable& made : mode_tables(rows)) {
    write_file(folder / (made.name + ".md"), to_markdown(made.table));
    write_file(folder / (made.name + ".csv"), to_csv(made.table));
  }
}

}  // namespace raysweep
