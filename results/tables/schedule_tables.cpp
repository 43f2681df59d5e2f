#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "results/factors.h"
#include "results/tables/number_text.h"
#include "results/tables/tables.h"

namespace raysweep {

namespace {

bool is_serial(const CellRow& row) { return row.cell.scheduler == "serial"; }

/// "99.1 %"
std::string tenths(const std::optional<double>& v) { return v ? fmt::format("{:.1f} %", *v * 100) : "–"; }

std::optional<double> value_of(const std::optional<Estimate>& e) {
  return e ? std::optional(e->value) : std::nullopt;
}

std::optional<double> share(const CellRow& row, double TimeShares::*part) {
  return row.schedule.shares ? std::optional(*row.schedule.shares.*part) : std::nullopt;
}

/// The size of the middle chunk.
uint64_t median_size(const std::map<uint64_t, double>& sizes) {
  double all = 0, below = 0;
  for (const auto& [size, count] : sizes) all += count;
  for (const auto& [size, count] : sizes) {
    below += count;
    if (2 * below >= all) return size;
  }
  return 0;
}

/// "96", "67 to 68", or for more sizes smallest–median–largest: "1–24–192".
std::string sizes_text(const std::map<uint64_t, double>& sizes) {
  const uint64_t smallest = sizes.begin()->first, largest = sizes.rbegin()->first;
  if (sizes.size() == 1) return std::to_string(smallest);
  if (sizes.size() == 2) return fmt::format("{} to {}", smallest, largest);
  return fmt::format("{}–{}–{}", smallest, median_size(sizes), largest);
}

/// Asked → made: their sizes. "4/thread → 8: 96"; without the first where nothing can be asked.
std::string chunks_text(const CellRow& row) {
  const Schedule& s = row.schedule;
  if (!s.chunks || s.chunk_sizes.empty()) return "–";
  return fmt::format("{}{}: {}", row.cell.chunk == "-" ? "" : row.cell.chunk + " → ", std::llround(*s.chunks),
                     sizes_text(s.chunk_sizes));
}

std::string microseconds(const std::optional<Estimate>& e) {
  return e ? significant(e->value * 1e6) + " µs" : "–";
}

std::string notes_of(const CellRow& row) {
  const int valid = row.launches - row.void_launches, off = row.schedule.log_off;
  if (off == 0) return "";
  return off == valid ? "log off" : fmt::format("log off in {} of {} launches", off, valid);
}

struct ScheduleColumn {
  const char* title;
  std::string (*text)(const CellRow&);
  bool against_serial = false;  // a comparison that the serial row is the base of
};

constexpr ScheduleColumn schedule_columns[]{
    {"quality", [](const CellRow& row) { return percent(row.schedule.quality); }, true},
    {"imbalance", [](const CellRow& row) { return tenths(value_of(row.schedule.imbalance)); }},
    {"busy", [](const CellRow& row) { return tenths(share(row, &TimeShares::busy)); }},
    {"in scheduler", [](const CellRow& row) { return tenths(share(row, &TimeShares::scheduling)); }},
    {"idle", [](const CellRow& row) { return tenths(share(row, &TimeShares::idle)); }},
    {"inflation", [](const CellRow& row) { return tenths(value_of(row.schedule.inflation)); }, true},
    {"chunks", chunks_text},
    {"empty region", [](const CellRow& row) { return microseconds(row.schedule.empty_region_seconds); }},
    {"migrations",
     [](const CellRow& row) {
       const auto& e = row.schedule.migrations;
       return e ? fmt::format("{:.3g}", e->value) : std::string("–");
     }},
};

std::string cell_text(const ScheduleColumn& column, const CellRow& row) {
  return column.against_serial && is_serial(row) ? "base" : column.text(row);
}

/// Whether a row says more than that it is the base, or that there is nothing.
bool has_values(const ScheduleColumn& column, const std::vector<CellRow>& rows) {
  return std::ranges::any_of(rows, [&](const CellRow& row) {
    const std::string text = cell_text(column, row);
    return text != "base" && text != "–";
  });
}

std::vector<std::string> factor_cells(const std::vector<FactorText>& factors, const CellRow& row) {
  std::vector<std::string> cells;
  for (const FactorText& f : factors) cells.push_back(f.text(row.cell));
  return cells;
}

Table with_factor_columns(const std::vector<FactorText>& factors) {
  Table table;
  for (const FactorText& f : factors) table.columns.push_back({f.name, f.number});
  return table;
}

}  // namespace

std::optional<Table> schedule_table(const std::vector<CellRow>& rows) {
  std::vector<ScheduleColumn> columns;
  std::ranges::copy_if(schedule_columns, std::back_inserter(columns),
                       [&](const ScheduleColumn& column) { return has_values(column, rows); });
  if (columns.empty()) return std::nullopt;
  const auto factors = varying_factors(rows);
  Table table = with_factor_columns(factors);
  table.caption =
      "Where the time went: medians over launches\n"
      "quality: the least that any schedule of these items needs on so many processors / what the frame "
      "took\n"
      "busy + in scheduler + idle: all threads' time; inflation: busy time against that of one thread\n"
      "chunks: asked → made: items in each; migrations: of all threads in a frame";
  for (const ScheduleColumn& column : columns) table.columns.push_back({column.title});
  const bool noted = std::ranges::any_of(rows, [](const CellRow& row) { return !notes_of(row).empty(); });
  if (noted) table.columns.push_back({"notes", false});
  for (const CellRow& row : rows) {
    auto cells = factor_cells(factors, row);
    for (const ScheduleColumn& column : columns) cells.push_back(cell_text(column, row));
    if (noted) cells.push_back(notes_of(row));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

Table schedule_data(const std::vector<CellRow>& rows) {
  Table table = with_factor_columns(factor_texts());
  for (const char* title : {"quality", "imbalance", "inflation", "empty_region_seconds", "migrations"}) {
    for (const char* part : {"", "_low", "_high"}) table.columns.push_back({std::string(title) + part});
  }
  for (const char* title : {"busy", "in_scheduler", "idle", "chunks", "log_off"})
    table.columns.push_back({title});
  for (const CellRow& row : rows) {
    const Schedule& s = row.schedule;
    auto cells = factor_cells(factor_texts(), row);
    for (const auto& e : {s.quality, s.imbalance, s.inflation, s.empty_region_seconds, s.migrations}) {
      for (std::string& number : unrounded(e)) cells.push_back(std::move(number));
    }
    for (const auto part : {&TimeShares::busy, &TimeShares::scheduling, &TimeShares::idle})
      cells.push_back(unrounded(share(row, part)));
    cells.push_back(unrounded(s.chunks));
    cells.push_back(std::to_string(s.log_off));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

Table chunk_data(const std::vector<CellRow>& rows) {
  Table table = with_factor_columns(factor_texts());
  for (const char* title : {"size", "chunks_per_frame"}) table.columns.push_back({title});
  for (const CellRow& row : rows) {
    for (const auto& [size, count] : row.schedule.chunk_sizes) {
      auto cells = factor_cells(factor_texts(), row);
      cells.push_back(std::to_string(size));
      cells.push_back(fmt::format("{}", count));
      table.rows.push_back(std::move(cells));
    }
  }
  return table;
}

}  // namespace raysweep
