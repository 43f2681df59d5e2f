#include <fmt/format.h>

#include "results/factors.h"
#include "results/hyper_threading.h"
#include "results/tables/comparison_text.h"
#include "results/tables/number_text.h"

namespace raysweep {

namespace {

/// "`subject` adds 25 % [24, 26]", from a comparison of fps.
std::string words_of(const char* subject, const std::optional<Estimate>& ratio,
                     const std::optional<Change>& change, const NoiseFloor& floor) {
  if (!ratio) return "–";
  switch (verdict_of(change, floor)) {
    case Verdict::faster:
      return fmt::format("{} adds {}", subject, amount(*change));
    case Verdict::slower:
      return fmt::format("{} takes {}", subject, amount(*change));
    case Verdict::no_difference:
      return "no difference shown";
    case Verdict::too_few:
      break;
  }
  return "no interval: fewer than 6 launches";
}

/// The factors that tell the groups apart: placement decides threads and pin.
std::vector<FactorText> without_placement(std::vector<FactorText> factors) {
  std::erase_if(factors, [](const FactorText& f) { return f.name == "threads" || f.name == "pin"; });
  return factors;
}

struct Line {
  const char* placement;
  const CellRow* row;
  std::string ratio, words;
};

std::vector<Line> lines_of(const HyperThreadingGroup& group, const NoiseFloor& floor) {
  std::vector<Line> lines{
      {"one thread a core", group.one_each, "base", ""},
      {"two threads a core", group.two_each, with_interval(group.yield),
       words_of("yield: a second hardware thread", group.yield, group.yield_change, floor)}};
  if (group.packed) {
    lines.push_back({"half the cores", group.packed, with_interval(group.packing_penalty),
                     words_of("packing penalty: filling half the cores", group.packing_penalty,
                              group.packing_change, floor)});
  }
  return lines;
}

}  // namespace

Table hyper_threading_table(const std::vector<CellRow>& rows, const std::vector<HyperThreadingGroup>& groups,
                            const NoiseFloor& floor) {
  const auto factors = without_placement(varying_factors(rows));
  Table table;
  table.caption =
      "Hyper-threading: fps against as many threads as cores, one on each; threads are bound\n"
      "words hold trimmed means with intervals corrected for all comparisons here, " +
      floor.to_text();
  for (const FactorText& f : factors) table.columns.push_back({f.name, f.number});
  table.columns.push_back({"placement", false});
  for (const char* title :
       {"threads", "cores", "fps", "eff/core", "eff/hardware thread", "against one a core"})
    table.columns.push_back({title});
  table.columns.push_back({"in words", false});
  for (const HyperThreadingGroup& group : groups) {
    for (const Line& line : lines_of(group, floor)) {
      const CellRow& row = *line.row;
      std::vector<std::string> cells;
      for (const FactorText& f : factors) cells.push_back(f.text(row.cell));
      cells.insert(cells.end(),
                   {line.placement, std::to_string(row.cell.threads), std::to_string(row.cell.cores_seen),
                    with_interval(row.fps), percent(row.core_efficiency),
                    percent(hardware_thread_efficiency(row)), line.ratio, line.words});
      table.rows.push_back(std::move(cells));
    }
  }
  return table;
}

Table hyper_threading_data(const std::vector<HyperThreadingGroup>& groups) {
  const auto factors = without_placement(factor_texts());
  Table table;
  for (const FactorText& f : factors) table.columns.push_back({f.name, f.number});
  table.columns.push_back({"cores"});
  for (const char* title : {"yield", "packing_penalty"}) {
    for (const char* part : {"", "_low", "_high"}) table.columns.push_back({std::string(title) + part});
  }
  for (const char* placement : {"one_each", "two_each", "packed"}) {
    for (const char* title : {"pin", "fps", "core_efficiency", "hardware_thread_efficiency"})
      table.columns.push_back({fmt::format("{}_{}", placement, title)});
  }
  for (const HyperThreadingGroup& group : groups) {
    std::vector<std::string> cells;
    for (const FactorText& f : factors) cells.push_back(f.text(group.one_each->cell));
    cells.push_back(std::to_string(group.cores()));
    for (const auto& ratio : {group.yield, group.packing_penalty}) {
      for (std::string& number : unrounded(ratio)) cells.push_back(std::move(number));
    }
    for (const CellRow* const row : {group.one_each, group.two_each, group.packed}) {
      if (!row) {
        cells.resize(cells.size() + 4);
        continue;
      }
      cells.insert(cells.end(), {row->cell.pin, unrounded(row->fps)[0], unrounded(row->core_efficiency),
                                 unrounded(hardware_thread_efficiency(*row))});
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

}  // namespace raysweep
