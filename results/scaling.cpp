#include "results/scaling.h"

#include <fmt/format.h>

#include <algorithm>

#include "results/noise_floor.h"
#include "results/rounds.h"
#include "results/statistics/stability.h"
#include "results/suspicions.h"

namespace raysweep {

namespace {

std::optional<Estimate> fps_ratio(const Rounds& of, const Rounds& base) {
  return paired(of, base, [](const Record* own, const Record* other) {
    return std::optional(own->fps() / other->fps());
  });
}

/// Cores that the threads can fill: where they are bound, those of their processors.
int fillable_cores(const Record& r) {
  return r.is_bound() && r.cores_seen > 0 ? r.cores_seen : std::min(r.threads, r.machine.cores);
}

void add_frames(CellRow& row, const Rounds& rounds) {
  for (const auto& [round, launch] : rounds) {
    auto& frames = row.frame_seconds.emplace_back();
    for (const auto& of_process : launch->frame_seconds)
      frames.insert(frames.end(), of_process.begin(), of_process.end());
    if (!launch->warmup_seconds.empty()) row.cold_seconds.push_back(launch->warmup_seconds.front());
  }
}

/// What a reader of its numbers must know about the launches themselves.
void add_warnings(CellRow& row, const NoiseFloor& floor) {
  const auto add = [&](const std::vector<std::string>& notes) {
    row.notes.insert(row.notes.end(), notes.begin(), notes.end());
  };
  add(row.disturbance.reasons);
  add(suspicions(row, floor));
  std::vector<double> fps;
  for (const auto& [round, value] : row.fps_by_round) fps.push_back(value);
  add(stability_warnings(fps));
}

void add_notes(CellRow& row, double interval_target, const NoiseFloor& floor) {
  const Record& r = row.cell;
  if (row.launches == 0) row.notes.push_back("not measured: the run ended before its first launch");
  if (row.oversubscribed) row.notes.push_back("oversubscribed");
  if (r.machine.quota && r.threads > *r.machine.quota) {
    row.notes.push_back(
        fmt::format("more threads than the control group's quota of {:.3g} processors", *r.machine.quota));
  }
  if (r.shares_cache_lines && r.threads > 1) row.notes.push_back("items share cache lines");
  if (row.void_launches > 0) {
    row.notes.push_back(fmt::format("{} of {} launches void: {}", row.void_launches, row.launches, r.reason));
  }
  if (r.threads_seen != r.threads && row.fps) {
    row.notes.push_back(fmt::format("{} of {} threads ran", r.threads_seen, r.threads));
  }
  if (!row.fps) return;
  add_warnings(row, floor);
  if (const auto width = row.fps->relative_half_width(); !width) {
    row.notes.push_back("no interval: fewer than 6 launches");
  } else if (*width > interval_target) {
    row.notes.push_back(fmt::format("not converged: ±{:.1f} %", *width * 100));
  }
}

/// The row's factors and what its launches have in common.
CellRow describe(const Record& planned, const std::vector<const Record*>& launches) {
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
    if (!r->valid) continue;
    row.cell.threads_seen = std::min(row.cell.threads_seen, r->threads_seen);
    row.cell.cores_seen = std::max(row.cell.cores_seen, r->cores_seen);
    row.cell.processors_seen = std::max(row.cell.processors_seen, r->processors_seen);
  }
  row.oversubscribed = row.launches > 0 && row.cell.threads > row.cell.processors_to_use();
  return row;
}

CellRow make_row(const Record& planned, const Launches& all, std::optional<double> usual_spin) {
  CellRow row = describe(planned, all.of_cell(planned.cell));
  const Record& r = row.cell;
  const Rounds& rounds = all.valid(own_key(r));
  if (rounds.empty()) return row;

  std::vector<double> fps;
  for (const auto& [round, launch] : rounds) fps.push_back(row.fps_by_round[round] = launch->fps());
  row.fps = estimate_median(std::move(fps));
  add_frames(row, rounds);
  row.disturbance = disturbance_of(rounds, usual_spin);
  const Rounds& serial = all.valid(serial_key(r));
  row.schedule = schedule_of(rounds, serial);
  row.speedup = fps_ratio(rounds, serial);
  row.speedup_one = fps_ratio(rounds, all.valid(one_thread_key(r)));
  if (row.speedup) {
    row.efficiency = row.speedup->value / r.threads;
    row.core_efficiency = row.speedup->value / fillable_cores(r);
  }
  const int processes = std::min(r.threads, r.machine.pus);
  if (processes == 1) return row;  // a process alone has no ceiling but itself
  // The co-running processes have all processors: no ceiling for threads that are bound to fewer.
  if (r.processors_to_use() < processes) return row;
  const Rounds& together = all.valid(serial_key(r, processes));
  row.ceiling = fps_ratio(together, serial);
  row.of_ceiling = fps_ratio(rounds, together);
  return row;
}

}  // namespace

std::vector<CellRow> summarise(const std::vector<Record>& records, const std::vector<Record>& planned,
                               double interval_target) {
  const Launches all(records);
  const auto usual_spin = usual_spin_seconds(records);
  const NoiseFloor floor = noise_floor(records);
  std::vector<CellRow> rows;
  for (const Record& cell : planned) {
    if (cell.processes > 1 || cell.twin > 0) continue;
    rows.push_back(make_row(cell, all, usual_spin));
    add_notes(rows.back(), interval_target, floor);
  }
  return rows;
}

}  // namespace raysweep
