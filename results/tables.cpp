#include "results/tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "results/factors.h"
#include "results/hyper_threading.h"
#include "results/number_text.h"

namespace raysweep {

namespace {

void write_file(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw std::runtime_error(file.string() + ": cannot be written");
}

}  // namespace

Table scaling_table(const std::vector<CellRow>& rows, const TableContext& context) {
  const auto factors = varying_factors(rows);
  Table table;
  table.caption =
      fmt::format("{}: {}\n{}", context.experiment, context.title, constant_factors(rows, factors));
  const auto launched = std::ranges::find_if(rows, [](const CellRow& row) { return row.launches > 0; });
  if (launched != rows.end()) {
    const MachineRecord& machine = launched->cell.machine;
    table.caption += fmt::format(
        "\n{}: {}, {} cores, {} processors; brackets hold 95 % intervals of the median over launches",
        machine.host, machine.cpu, machine.cores, machine.pus);
  }
  for (const FactorText& f : factors) table.columns.push_back({f.name, f.number});
  for (const char* title :
       {"fps", "speedup", "vs 1 thread", "eff/thread", "eff/core", "ceiling", "of ceiling"}) {
    table.columns.push_back({title});
  }
  table.columns.push_back({"notes", false});
  for (const CellRow& row : rows) {
    std::vector<std::string> cells;
    for (const FactorText& f : factors) cells.push_back(f.text(row.cell));
    cells.push_back(with_interval(row.fps));
    cells.push_back(row.cell.scheduler == "serial" ? "base" : with_interval(row.speedup));
    cells.push_back(row.cell.threads == 1 ? "base"
                    : row.speedup_one     ? significant(row.speedup_one->value)
                                          : "–");
    cells.push_back(percent(row.efficiency));
    cells.push_back(percent(row.core_efficiency));
    cells.push_back(row.ceiling ? significant(row.ceiling->value) : "–");
    cells.push_back(percent(row.of_ceiling));
    cells.push_back(fmt::format("{}", fmt::join(row.notes, "; ")));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

Table scaling_data(const std::vector<CellRow>& rows) {
  Table table;
  for (const FactorText& f : factor_texts()) table.columns.push_back({f.name, f.number});
  for (const char* title : {"threads_seen", "launches", "void_launches"}) table.columns.push_back({title});
  for (const char* title : {"fps", "speedup", "speedup_one", "ceiling", "of_ceiling"}) {
    for (const char* part : {"", "_low", "_high"}) table.columns.push_back({std::string(title) + part});
  }
  for (const char* title : {"efficiency", "core_efficiency", "oversubscribed"})
    table.columns.push_back({title});
  table.columns.push_back({"notes", false});
  for (const CellRow& row : rows) {
    std::vector<std::string> cells;
    for (const FactorText& f : factor_texts()) cells.push_back(f.text(row.cell));
    for (const int v : {row.cell.threads_seen, row.launches, row.void_launches})
      cells.push_back(std::to_string(v));
    for (const auto& e : {row.fps, row.speedup, row.speedup_one, row.ceiling, row.of_ceiling}) {
      for (std::string& number : unrounded(e)) cells.push_back(std::move(number));
    }
    cells.push_back(unrounded(row.efficiency));
    cells.push_back(unrounded(row.core_efficiency));
    cells.push_back(row.oversubscribed ? "1" : "0");
    cells.push_back(fmt::format("{}", fmt::join(row.notes, "; ")));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

nlohmann::json rows_as_json(const std::vector<CellRow>& rows) {
  const Table table = scaling_data(rows);
  auto list = nlohmann::json::array();
  for (const auto& cells : table.rows) {
    nlohmann::json row;
    for (size_t i = 0; i < cells.size(); ++i) row[table.columns[i].title] = cells[i];
    list.push_back(std::move(row));
  }
  return list;
}

std::string tables_as_text(const std::vector<CellRow>& rows, const TableContext& context) {
  std::string text = to_text(scaling_table(rows, context));
  const auto add = [&](const Table& table) { text.append("\n").append(to_text(table)); };
  if (const auto schedule = schedule_table(rows)) add(*schedule);
  if (const auto groups = hyper_threading_groups(rows); !groups.empty())
    add(hyper_threading_table(rows, groups));
  for (const ModeTable& made : mode_tables(rows)) add(made.table);
  return text;
}

void write_tables(const std::vector<CellRow>& rows, const TableContext& context,
                  const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  write_file(folder / "scaling.md", to_markdown(scaling_table(rows, context)));
  write_file(folder / "scaling.csv", to_csv(scaling_data(rows)));
  if (const auto schedule = schedule_table(rows)) {
    write_file(folder / "schedule.md", to_markdown(*schedule));
    write_file(folder / "schedule.csv", to_csv(schedule_data(rows)));
    write_file(folder / "chunks.csv", to_csv(chunk_data(rows)));
  }
  if (const auto groups = hyper_threading_groups(rows); !groups.empty()) {
    write_file(folder / "hyper-threading.md", to_markdown(hyper_threading_table(rows, groups)));
    write_file(folder / "hyper-threading.csv", to_csv(hyper_threading_data(groups)));
  }
  for (const ModeTable& made : mode_tables(rows)) {
    write_file(folder / (made.name + ".md"), to_markdown(made.table));
    write_file(folder / (made.name + ".csv"), to_csv(made.table));
  }
}

}  // namespace raysweep
