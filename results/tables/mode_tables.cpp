#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "results/factors.h"
#include "results/tables/number_text.h"
#include "results/tables/tables.h"

namespace raysweep {

namespace {

/// Rows that share everything but threads and mode.
struct Group {
  std::string name;
  std::map<int, std::map<std::string, const CellRow*>> rows;  // by threads, by mode
};

/// "omp_static", with the other factors that vary: "omp_static-chunk4".
std::string group_name(const CellRow& row, const std::vector<FactorText>& varying) {
  std::string name = row.cell.scheduler;
  for (const FactorText& f : varying) {
    if (f.name == "scheduler" || f.name == "mode" || f.name == "threads" || f.text(row.cell) == "-") continue;
    name += fmt::format("-{}{}", f.name, f.text(row.cell));
  }
  std::ranges::replace_if(
      name, [](char c) { return c == '/' || c == ':' || c == ' '; }, '_');  // it names a file
  return name;
}

std::vector<Group> group_rows(const std::vector<CellRow>& rows) {
  const auto varying = varying_factors(rows);
  std::vector<Group> groups;
  for (const CellRow& row : rows) {
    const std::string name = group_name(row, varying);
    auto group = std::ranges::find(groups, name, &Group::name);
    if (group == groups.end()) group = groups.insert(group, Group{name, {}});
    group->rows[row.cell.threads][row.cell.mode] = &row;
  }
  return groups;
}

/// What a reader of one line must know: oversubscription once, the rest by mode.
std::string notes_of(const std::map<std::string, const CellRow*>& by_mode) {
  std::string text;
  const auto add = [&](const std::string& note) {
    text += fmt::format("{}{}", text.empty() ? "" : "; ", note);
  };
  if (by_mode.begin()->second->oversubscribed) add("oversubscribed");
  for (const auto& [mode, row] : by_mode) {
    for (const std::string& note : row->notes) {
      if (note != "oversubscribed") add(fmt::format("{} {}", mode, note));
    }
  }
  return text;
}

ModeTable make_table(const char* quantity, std::optional<Estimate> CellRow::*value, const Group& group,
                     const std::vector<std::string>& modes) {
  ModeTable made{fmt::format("{}-{}", quantity, group.name), {}};
  made.table.columns.push_back({"threads"});
  for (const std::string& mode : modes) made.table.columns.push_back({mode});
  made.table.columns.push_back({"notes", false});
  for (const auto& [threads, by_mode] : group.rows) {
    std::vector<std::string> cells{std::to_string(threads)};
    for (const std::string& mode : modes) {
      const auto found = by_mode.find(mode);
      const bool known = found != by_mode.end() && (found->second->*value).has_value();
      cells.push_back(known ? significant((found->second->*value)->value) : "");
    }
    cells.push_back(notes_of(by_mode));
    made.table.rows.push_back(std::move(cells));
  }
  return made;
}

}  // namespace

std::vector<ModeTable> mode_tables(const std::vector<CellRow>& rows) {
  std::vector<std::string> modes;
  for (const CellRow& row : rows) {
    if (std::ranges::find(modes, row.cell.mode) == modes.end()) modes.push_back(row.cell.mode);
  }
  std::vector<ModeTable> tables;
  if (modes.size() < 2) return tables;
  for (const Group& group : group_rows(rows)) {
    tables.push_back(make_table("fps", &CellRow::fps, group, modes));
    tables.back().table.caption = fmt::format("fps of {}", group.name);
    tables.push_back(make_table("speedup", &CellRow::speedup, group, modes));
    tables.back().table.caption = fmt::format("speedup of {} against serial", group.name);
  }
  return tables;
}

}  // namespace raysweep
