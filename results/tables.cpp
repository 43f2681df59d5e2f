#include "results/tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>

#include "results/factors.h"

namespace raysweep {

namespace {

/// Four significant digits, as published tables print them.
std::string significant(double v) {
  const double size = std::abs(v);
  return size >= 1000 ? fmt::format("{:.0f}", v) : size >= 100 ? fmt::format("{:.1f}", v) : size >= 10 ? fmt::format("{:.2f}", v) : fmt::format("{:.3f}", v);
}

std::string with_interval(const std::optional<Estimate>& e) {
  if (!e) return "–";
  if (!e->interval) return significant(e->value);
  return fmt::format("{} [{}, {}]", significant(e->value), significant(e->interval->low), significant(e->interval->high));
}

std::string percent(const std::optional<double>& v) { return v ? fmt::format("{:.0f} %", *v * 100) : "–"; }

/// "99.1 % [98.0, 100.2]"
std::string percent(const std::optional<Estimate>& e) {
  if (!e) return "–";
  if (!e->interval) return fmt::format("{:.1f} %", e->value * 100);
  return fmt::format("{:.1f} % [{:.1f}, {:.1f}]", e->value * 100, e->interval->low * 100, e->interval->high * 100);
}

/// Factors with more than one value among `rows`; scheduler and threads always count as varying. A "-" (the scheduler
/// ignores the factor) is no value of its own.
std::vector<FactorText> varying_factors(const std::vector<CellRow>& rows) {
  std::vector<FactorText> varying;
  for (const FactorText& factor : factor_texts()) {
    std::set<std::string> values;
    for (const CellRow& row : rows) values.insert(factor.text(row.cell));
    values.erase("-");
    const std::string name = factor.name;
    if (values.size() > 1 || name == "scheduler" || name == "threads") varying.push_back(factor);
  }
  return varying;
}

bool holds(const std::vector<FactorText>& list, const FactorText& factor) {
  return std::ranges::any_of(list, [&](const FactorText& f) { return f.name == factor.name; });
}

/// The factors that do not vary, in one line. Where modes vary they stand for the numbers that they set.
std::string constant_factors(const std::vector<CellRow>& rows, const std::vector<FactorText>& varying) {
  std::string text;
  for (const FactorText& factor : factor_texts()) {
    if (holds(varying, factor)) continue;
    std::string value = "-";
    for (const CellRow& row : rows) {
      if (value == "-") value = factor.text(row.cell);
    }
    if (value != "-" && !value.empty()) text += fmt::format("{}{} {}", text.empty() ? "" : " · ", factor.name, value);
  }
  return text;
}

/// The columns that a mode decides alone say nothing beside the mode's name.
std::vector<FactorText> without_mode_details(const std::vector<CellRow>& rows, std::vector<FactorText> varying) {
  for (const char* detail : {"width", "height", "subpixels", "depth", "lights"}) {
    const auto found = std::ranges::find_if(varying, [&](const FactorText& f) { return std::string(f.name) == detail; });
    if (found == varying.end()) continue;
    std::map<std::string, std::set<std::string>> values;
    for (const CellRow& row : rows) values[row.cell.mode].insert(found->text(row.cell));
    if (std::ranges::all_of(values, [](const auto& v) { return v.second.size() == 1; })) varying.erase(found);
  }
  return varying;
}

void write_file(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw std::runtime_error(file.string() + ": cannot be written");
}

}  // namespace

Table scaling_table(const std::vector<CellRow>& rows, const TableContext& context) {
  const auto factors = without_mode_details(rows, varying_factors(rows));
  Table table;
  table.caption = fmt::format("{}: {}\n{}", context.experiment, context.title, constant_factors(rows, factors));
  if (!rows.empty()) {
    const MachineRecord& machine = rows.front().cell.machine;
    table.caption += fmt::format("\n{}: {}, {} cores, {} processors; brackets hold 95 % intervals of the median over launches",
                                 machine.host, machine.cpu, machine.cores, machine.pus);
  }
  for (const FactorText& f : factors) table.columns.push_back({f.name, f.number});
  for (const char* title : {"fps", "speedup", "vs 1 thread", "eff/thread", "eff/core", "ceiling", "of ceiling"}) {
    table.columns.push_back({title});
  }
  table.columns.push_back({"notes", false});
  for (const CellRow& row : rows) {
    std::vector<std::string> cells;
    for (const FactorText& f : factors) cells.push_back(f.text(row.cell));
    cells.push_back(with_interval(row.fps));
    cells.push_back(with_interval(row.speedup));
    cells.push_back(row.speedup_one ? significant(row.speedup_one->value) : "–");
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
  for (const char* title : {"efficiency", "core_efficiency", "oversubscribed"}) table.columns.push_back({title});
  table.columns.push_back({"notes", false});
  const auto number = [](const std::optional<double>& v) { return v ? fmt::format("{}", *v) : std::string(); };
  for (const CellRow& row : rows) {
    std::vector<std::string> cells;
    for (const FactorText& f : factor_texts()) cells.push_back(f.text(row.cell));
    for (const int v : {row.cell.threads_seen, row.launches, row.void_launches}) cells.push_back(std::to_string(v));
    for (const auto& e : {row.fps, row.speedup, row.speedup_one, row.ceiling, row.of_ceiling}) {
      const bool bounded = e && e->interval;
      cells.push_back(e ? fmt::format("{}", e->value) : "");
      cells.push_back(bounded ? fmt::format("{}", e->interval->low) : "");
      cells.push_back(bounded ? fmt::format("{}", e->interval->high) : "");
    }
    cells.push_back(number(row.efficiency));
    cells.push_back(number(row.core_efficiency));
    cells.push_back(row.oversubscribed ? "1" : "0");
    cells.push_back(fmt::format("{}", fmt::join(row.notes, "; ")));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

std::vector<ModeTable> mode_tables(const std::vector<CellRow>& rows) {
  std::vector<std::string> modes;
  for (const CellRow& row : rows) {
    if (std::ranges::find(modes, row.cell.mode) == modes.end()) modes.push_back(row.cell.mode);
  }
  if (modes.size() < 2) return {};
  const auto factors = without_mode_details(rows, varying_factors(rows));
  std::vector<std::string> names;                                           // groups, in order
  std::map<std::string, std::map<int, std::map<std::string, const CellRow*>>> groups;  // name → threads → mode
  for (const CellRow& row : rows) {
    std::string name;
    for (const FactorText& f : factors) {
      const std::string factor = f.name;
      if (factor == "mode" || factor == "threads" || f.text(row.cell) == "-") continue;
      name += (name.empty() ? "" : "-") + (factor == "scheduler" ? "" : factor) + f.text(row.cell);
    }
    std::ranges::replace_if(name, [](char c) { return c == '/' || c == ':' || c == ' '; }, '_');
    if (!groups.contains(name)) names.push_back(name);
    groups[name][row.cell.threads][row.cell.mode] = &row;
  }
  std::vector<ModeTable> tables;
  for (const std::string& name : names) {
    const auto add = [&](const char* quantity, auto&& text) {
      ModeTable made{fmt::format("{}-{}", quantity, name), {}};
      made.table.caption = fmt::format("{} of {}", quantity, name);
      made.table.columns.push_back({"threads"});
      for (const std::string& mode : modes) made.table.columns.push_back({mode});
      for (const auto& [threads, by_mode] : groups[name]) {
        std::vector<std::string> cells{std::to_string(threads)};
        for (const std::string& mode : modes) {
          const auto found = by_mode.find(mode);
          cells.push_back(found == by_mode.end() ? "" : text(*found->second));
        }
        made.table.rows.push_back(std::move(cells));
      }
      tables.push_back(std::move(made));
    };
    add("fps", [](const CellRow& row) { return row.fps ? significant(row.fps->value) : ""; });
    add("speedup", [](const CellRow& row) { return row.speedup ? significant(row.speedup->value) : ""; });
  }
  return tables;
}

std::string tables_as_text(const std::vector<CellRow>& rows, const TableContext& context) {
  std::string text = to_text(scaling_table(rows, context));
  for (const ModeTable& made : mode_tables(rows)) text += "\n" + to_text(made.table);
  return text;
}

void write_tables(const std::vector<CellRow>& rows, const TableContext& context, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  write_file(folder / "scaling.md", to_markdown(scaling_table(rows, context)));
  write_file(folder / "scaling.csv", to_csv(scaling_data(rows)));
  for (const ModeTable& made : mode_tables(rows)) {
    write_file(folder / (made.name + ".md"), to_markdown(made.table));
    write_file(folder / (made.name + ".csv"), to_csv(made.table));
  }
}

}  // namespace raysweep
