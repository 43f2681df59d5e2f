// Where the time of a cell's frames went, and how close that is to the best that any schedule could do.
#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "results/rounds.h"
#include "results/statistics/statistics.h"

namespace raysweep {

/// Of threads × the time of the frames; they add up to 1.
struct TimeShares {
  double busy = 0, scheduling = 0, idle = 0;
};

/// Estimates are medians over valid launches; what a launch did not log or measure counts for nothing.
struct Schedule {
  /// The tile-cost bound max(Σ cost/p, largest cost) by what the frame took. Costs are those of the serial
  /// launch of the same round; p is the number of threads, as far as there are processors for them.
  std::optional<Estimate> quality;
  std::optional<Estimate> imbalance;  // of the workers' busy times: max/mean − 1
  std::optional<Estimate> inflation;  // busy time by the serial cost of the same items, − 1
  /// Of the launch whose busy share is the median: medians of the three would not add up to 1.
  std::optional<TimeShares> shares;
  std::optional<Estimate> empty_region_seconds;
  std::optional<Estimate> migrations;      // of all workers, a frame
  std::optional<double> chunks;            // a frame; median over all frames
  std::map<uint64_t, double> chunk_sizes;  // how many of each size a frame had, mean over all frames
  int log_off = 0;                         // launches that could not afford the log
};

/// The tile-cost bound of one launch by what its frame took; none where the serial launch measured no costs.
[[nodiscard]] std::optional<double> launch_quality(const Record& own, const Record& serial);

/// Of the workers' busy times; none of a launch without its log.
[[nodiscard]] std::optional<double> launch_imbalance(const Record& launch);

/// `own` are the launches of one cell, `serial` those of the cell that measured what its items cost.
[[nodiscard]] Schedule schedule_of(const Rounds& own, const Rounds& serial);

}  // namespace raysweep
