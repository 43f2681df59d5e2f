// From records to rows: each cell with its speedups, efficiencies and ceiling.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/record.h"
#include "results/statistics.h"

namespace raysweep {

/// One cell of a run. Ratios are taken launch by launch within a round, where both sides were measured next
/// to each other, and then summarised by their median.
struct CellRow {
  Record cell;  // the cell's first valid record, for its factors; the first one where none is valid
  int launches = 0, void_launches = 0;
  std::optional<Estimate> fps;            // none without a valid launch
  std::optional<Estimate> speedup;        // against `serial`, same picture and item shape
  std::optional<Estimate> speedup_one;    // against one thread of the same scheduler
  std::optional<double> efficiency;       // speedup per thread
  std::optional<double> core_efficiency;  // speedup per physical core that the threads can fill
  std::optional<Estimate> ceiling;  // what as many independent serial processes reach together, against one
  std::optional<Estimate> of_ceiling;  // fps as a share of what those processes reach
  bool oversubscribed = false;
  std::vector<std::string> notes;
};

/// The rows of `records`, in order of first appearance in `cell_order` (cells without any record get no row).
/// Co-run cells serve others and have no row of their own. `interval_target` is the relative half-width asked
/// for.
[[nodiscard]] std::vector<CellRow> summarise(const std::vector<Record>& records,
                                             const std::vector<std::string>& cell_order,
                                             double interval_target);

}  // namespace raysweep
