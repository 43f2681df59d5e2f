#include "results/scaling.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "results/factors.h"

namespace raysweep {

namespace {

/// Valid launches of one cell, by round.
using Rounds = std::map<int, double>;

/// Factors that the serial scheduler has no use for.
const std::set<std::string> only_of_threads{"runtime", "pin", "wait_policy", "spin_count", "environment"};

/// The factors of `r` as one text, with another scheduler, thread count and chunk: names the cell to compare
/// with.
std::string base_key(const Record& r, const std::string& scheduler, int threads, const std::string& chunk,
                     int processes) {
  std::string key = std::to_string(processes);
  for (const FactorText& factor : factor_texts()) {
    key += "|" + (factor.name == "scheduler"                                       ? scheduler
                  : factor.name == "threads"                                       ? std::to_string(threads)
                  : factor.name == "chunk"                                         ? chunk
                  : scheduler == "serial" && only_of_threads.contains(factor.name) ? "-"
                                                                                   : factor.text(r));
  }
  return key;
}

std::string own_key(const Record& r) { return base_key(r, r.scheduler, r.threads, r.chunk, r.processes); }

std::optional<Estimate> ratio(const Rounds& of, const std::map<std::string, Rounds>& all,
                              const std::string& base) {
  const auto found = all.find(base);
  if (found == all.end()) return std::nullopt;
  std::vector<double> ratios;
  for (const auto& [round, fps] : of) {
    if (const auto other = found->second.find(round); other != found->second.end())
      ratios.push_back(fps / other->second);
  }
  if (ratios.empty()) return std::nullopt;
  return estimate_median(std::move(ratios));
}

void add_notes(CellRow& row, double interval_target) {
  const Record& r = row.cell;
  if (row.launches == 0) row.notes.push_back("not measured: the run ended before its first launch");
  if (row.oversubscribed) row.notes.push_back("oversubscribed");
  if (row.void_launches > 0) {
    row.notes.push_back(fmt::format("{} of {} launches void: {}", row.void_launches, row.launches, r.reason));
  }
  if (r.threads_seen != r.threads && row.fps) {
    row.notes.push_back(fmt::format("{} of {} threads ran", r.threads_seen, r.threads));
  }
  if (!row.fps) return;
  if (const auto width = row.fps->relative_half_width(); !width) {
    row.notes.push_back("no interval: fewer than 6 launches");
  } else if (*width > interval_target) {
    row.notes.push_back(fmt::format("not converged: ±{:.1f} %", *width * 100));
  }
}

CellRow make_row(const Record& planned, const std::vector<const Record*>& launches,
                 const std::map<std::string, Rounds>& all) {
  const auto is_valid = [](const Record* r) { return r->valid; };
  const auto valid = std::ranges::find_if(launches, is_valid);
  const auto voided = std::ranges::find_if_not(launches, is_valid);
  CellRow row;
  row.cell = valid != launches.end() ? **valid : planned;
  row.launches = static_cast<int>(launches.size());
  row.void_launches = row.launches - static_cast<int>(std::ranges::count_if(launches, is_valid));
  if (voided != launches.end()) row.cell.reason = (*voided)->reason;
  if (!launches.empty()) row.cell.machine = launches.front()->machine;
  for (const Record* r : launches) {
    if (r->valid) row.cell.threads_seen = std::min(row.cell.threads_seen, r->threads_seen);
  }
  const Record& r = row.cell;
  row.oversubscribed = row.launches > 0 && r.threads > r.machine.pus;
  const auto own = all.find(own_key(r));
  if (own == all.end()) return row;

  const Rounds& rounds = own->second;
  std::vector<double> fps;
  for (const auto& [round, value] : rounds) fps.push_back(value);
  row.fps = estimate_median(std::move(fps));
  const std::string serial = base_key(r, "serial", 1, "-", 1);
  row.speedup = ratio(rounds, all, serial);
  row.speedup_one = ratio(rounds, all, base_key(r, r.scheduler, 1, r.chunk, 1));
  if (row.speedup) {
    row.efficiency = row.speedup->value / r.threads;
    row.core_efficiency = row.speedup->value / std::min(r.threads, r.machine.cores);
  }
  const int processes = std::min(r.threads, r.machine.pus);
  if (processes == 1) return row;  // a process alone has no ceiling but itself
  const std::string corun = base_key(r, "serial", 1, "-", processes);
  if (const auto reached = all.find(corun); reached != all.end())
    row.ceiling = ratio(reached->second, all, serial);
  row.of_ceiling = ratio(rounds, all, corun);
  return row;
}

}  // namespace

std::vector<CellRow> summarise(const std::vector<Record>& records, const std::vector<Record>& planned,
                               double interval_target) {
  // A launch that was void and tried again on resume has two records: the later one counts.
  std::map<std::pair<std::string, int>, const Record*> latest;
  for (const Record& r : records) latest[{r.cell, r.round}] = &r;
  std::map<std::string, Rounds> all;
  std::map<std::string, std::vector<const Record*>> by_cell;
  for (const auto& [cell_and_round, r] : latest) {
    by_cell[r->cell].push_back(r);
    if (r->valid) all[own_key(*r)][r->round] = r->fps();
  }
  std::vector<CellRow> rows;
  for (const Record& cell : planned) {
    if (cell.processes > 1) continue;
    rows.push_back(make_row(cell, by_cell[cell.cell], all));
    add_notes(rows.back(), interval_target);
  }
  return rows;
}

}  // namespace raysweep
