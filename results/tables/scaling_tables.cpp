#include <fmt/format.h>

#include <algorithm>

#include "results/best.h"
#include "results/factors.h"
#include "results/tables/number_text.h"
#include "results/tables/tables.h"

namespace raysweep {

namespace {

/// How the column `against the best` came about, and what is too small to be shown.
std::string comparisons_text(const Standings& standings, const NoiseFloor& floor) {
  if (standings.comparisons == 0) return floor.to_text();
  return fmt::format(
      "{}; against the best of as many threads: fps paired by round, corrected for all comparisons among "
      "them (up "
      "to {})",
      floor.to_text(), standings.comparisons);
}

std::vector<std::string> standing_data(const Standing& standing) {
  if (standing.place == Standing::Place::alone) return {"", "", "", "", ""};
  if (standing.place == Standing::Place::best)
    return {"1", "", "", "", standing.shown ? "fastest" : "best median"};
  if (!standing.change) return {"", "", "", "", to_string(standing.verdict)};
  const auto& [ratio, interval, p, count] = *standing.change;
  return {fmt::format("{}", ratio), fmt::format("{}", interval.low), fmt::format("{}", interval.high),
          unrounded(standing.adjusted_p), to_string(standing.verdict)};
}

/// How much longer one thread of a scheduler takes than none: T1/Ts − 1.
std::optional<double> scheduler_tax(const CellRow& row) {
  const bool is_one = row.cell.threads == 1 && row.cell.scheduler != "serial";
  return is_one && row.speedup ? std::optional(1 / row.speedup->value - 1) : std::nullopt;
}

}  // namespace

Table scaling_table(const std::vector<CellRow>& rows, const TableContext& context) {
  const auto factors = varying_factors(rows);
  const Standings standings = against_the_best(rows, context.floor);
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
  table.caption.append("\n").append(comparisons_text(standings, context.floor));
  for (const FactorText& f : factors) table.columns.push_back({f.name, f.number});
  for (const char* title :
       {"fps", "speedup", "vs 1 thread", "eff/thread", "eff/core", "ceiling", "of ceiling"}) {
    table.columns.push_back({title});
  }
  if (standings.comparisons > 0) table.columns.push_back({"against the best", false});
  table.columns.push_back({"notes", false});
  for (size_t i = 0; i < rows.size(); ++i) {
    const CellRow& row = rows[i];
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
    if (standings.comparisons > 0) cells.push_back(standings.rows[i].to_text(context.floor));
    cells.push_back(fmt::format("{}", fmt::join(row.notes, "; ")));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

Table scaling_data(const std::vector<CellRow>& rows, const NoiseFloor& floor) {
  const Standings standings = against_the_best(rows, floor);
  Table table;
  for (const FactorText& f : factor_texts()) table.columns.push_back({f.name, f.number});
  for (const char* title : {"threads_seen", "launches", "void_launches"}) table.columns.push_back({title});
  for (const char* title : {"fps", "speedup", "speedup_one", "ceiling", "of_ceiling"}) {
    for (const char* part : {"", "_low", "_high"}) table.columns.push_back({std::string(title) + part});
  }
  for (const char* title :
       {"scheduler_tax", "efficiency", "core_efficiency", "oversubscribed", "other_processors", "steal_share",
        "pressure_share", "spin_excess", "throttled_seconds"})
    table.columns.push_back({title});
  for (const char* title : {"against_best", "against_best_low", "against_best_high", "against_best_p"})
    table.columns.push_back({title});
  for (const char* title : {"against_best_verdict", "notes"}) table.columns.push_back({title, false});
  for (size_t i = 0; i < rows.size(); ++i) {
    const CellRow& row = rows[i];
    std::vector<std::string> cells;
    for (const FactorText& f : factor_texts()) cells.push_back(f.text(row.cell));
    for (const int v : {row.cell.threads_seen, row.launches, row.void_launches})
      cells.push_back(std::to_string(v));
    for (const auto& e : {row.fps, row.speedup, row.speedup_one, row.ceiling, row.of_ceiling}) {
      for (std::string& number : unrounded(e)) cells.push_back(std::move(number));
    }
    cells.push_back(unrounded(scheduler_tax(row)));
    cells.push_back(unrounded(row.efficiency));
    cells.push_back(unrounded(row.core_efficiency));
    cells.push_back(row.oversubscribed ? "1" : "0");
    const Disturbance& d = row.disturbance;
    for (const auto& value :
         {d.other_processors, d.steal_share, d.pressure_share, d.spin_excess, d.throttled_seconds})
      cells.push_back(unrounded(value));
    for (std::string& cell : standing_data(standings.rows[i])) cells.push_back(std::move(cell));
    cells.push_back(fmt::format("{}", fmt::join(row.notes, "; ")));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

}  // namespace raysweep
