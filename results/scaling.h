// From records to rows: each cell with its speedups, efficiencies and ceiling.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "results/record.h"
#include "results/schedule.h"
#include "results/spoilers.h"
#include "results/statistics/resampling.h"
#include "results/statistics/statistics.h"

namespace raysweep {

/// One cell of a run. Ratios are taken launch by launch within a round, where both sides were measured next
/// to each other, and then summarised by their median.
struct CellRow {
  Record cell;  // the cell's first valid record, for its factors; without one, the planned cell
  int launches = 0, void_launches = 0;
  std::map<int, double> fps_by_round;     // of valid launches
  std::optional<Estimate> fps;            // none without a valid launch
  std::optional<Estimate> speedup;        // against `serial`, same picture, items and order
  std::optional<Estimate> speedup_one;    // against one thread of the same scheduler
  std::optional<double> efficiency;       // speedup per thread
  std::optional<double> core_efficiency;  // speedup per physical core that the threads can fill
  std::optional<Estimate> ceiling;  // what as many independent serial processes reach together, against one
  std::optional<Estimate> of_ceiling;  // fps as a share of what those processes reach
  Schedule schedule;                   // where the time went
  FramesByLaunch frame_seconds;        // of valid launches, by round; those of co-running processes together
  std::vector<double> cold_seconds;    // their first frames, before any warm-up
  Disturbance disturbance;             // what else the machine did
  bool oversubscribed = false;
  std::vector<std::string> notes;
};

/// The rows of a run: one for each planned cell, in that order, whether it was launched or not. Co-run cells
/// and twins serve others and have no row of their own. `planned` are records without measurements;
/// `interval_target` is the relative half-width asked for.
[[nodiscard]] std::vector<CellRow> summarise(const std::vector<Record>& records,
                                             const std::vector<Record>& planned, double interval_target);

}  // namespace raysweep
