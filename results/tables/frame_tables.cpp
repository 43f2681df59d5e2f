#include "results/tables/frame_tables.h"

#include "results/factors.h"
#include "results/tables/number_text.h"

namespace raysweep {

namespace {

std::string milliseconds(const std::optional<double>& seconds) {
  return seconds ? significant(*seconds * 1000) : "–";
}

std::string milliseconds(Estimate seconds) {
  seconds.value *= 1000;
  if (seconds.interval) seconds.interval = {seconds.interval->low * 1000, seconds.interval->high * 1000};
  return with_interval(seconds);
}

}  // namespace

std::vector<std::optional<FrameTimes>> frame_times(const std::vector<CellRow>& rows) {
  std::vector<std::optional<FrameTimes>> times;
  for (const CellRow& row : rows) times.push_back(frame_times(row.frame_seconds, row.cold_seconds));
  return times;
}

Table frame_table(const std::vector<CellRow>& rows, const std::vector<std::optional<FrameTimes>>& times) {
  const auto factors = varying_factors(rows);
  Table table;
  table.caption =
      "Frame times in milliseconds, over all frames of all launches\n"
      "brackets hold 95 % intervals by a bootstrap over launches and frames; p95 has one where frames are "
      "worth 72 "
      "independent ones\n"
      "quantiles between two frames are on the line between them; p99 from 100 frames on\n"
      "the cold frame is a process's first";
  for (const FactorText& f : factors) table.columns.push_back({f.name, f.number});
  for (const char* title : {"launches", "frames", "p5", "p50", "p95", "p99", "max", "cold frame"})
    table.columns.push_back({title});
  for (size_t i = 0; i < rows.size(); ++i) {
    std::vector<std::string> cells;
    for (const FactorText& f : factors) cells.push_back(f.text(rows[i].cell));
    if (const auto& t = times[i]) {
      cells.insert(cells.end(), {std::to_string(t->launches), std::to_string(t->frames), milliseconds(t->p5),
                                 milliseconds(t->p50), milliseconds(t->p95), milliseconds(t->p99),
                                 milliseconds(t->max), milliseconds(t->cold)});
    }
    cells.resize(table.columns.size(), "–");
    table.rows.push_back(std::move(cells));
  }
  return table;
}

Table frame_data(const std::vector<CellRow>& rows, const std::vector<std::optional<FrameTimes>>& times) {
  Table table;
  for (const FactorText& f : factor_texts()) table.columns.push_back({f.name, f.number});
  for (const char* title : {"launches", "frames", "p5", "p50", "p50_low", "p50_high", "p95", "p95_low",
                            "p95_high", "p99", "max", "cold"})
    table.columns.push_back({title});
  for (size_t i = 0; i < rows.size(); ++i) {
    std::vector<std::string> cells;
    for (const FactorText& f : factor_texts()) cells.push_back(f.text(rows[i].cell));
    if (const auto& t = times[i]) {
      const auto p50 = unrounded(std::optional(t->p50)), p95 = unrounded(std::optional(t->p95));
      cells.insert(cells.end(),
                   {std::to_string(t->launches), std::to_string(t->frames), unrounded(std::optional(t->p5)),
                    p50[0], p50[1], p50[2], p95[0], p95[1], p95[2], unrounded(t->p99),
                    unrounded(std::optional(t->max)), unrounded(t->cold)});
    }
    cells.resize(table.columns.size());
    table.rows.push_back(std::move(cells));
  }
  return table;
}

}  // namespace raysweep
