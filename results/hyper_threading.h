// What a core's second hardware thread gives: the same cells, placed in three ways.
#pragma once

#include <optional>
#include <vector>

#include "results/comparison.h"
#include "results/scaling.h"
#include "results/tables/table.h"

namespace raysweep {

/// Cells that are equal in everything but how many threads they have and where those are bound. Points into
/// the rows that it was made from.
struct HyperThreadingGroup {
  const CellRow* one_each;          // C threads on C cores
  const CellRow* two_each;          // 2C threads on the same cores
  const CellRow* packed = nullptr;  // C threads on C/2 of them, if there is such a cell
  /// Against `one_each`, paired within rounds: what the second hardware threads give, and what is left with
  /// half the cores.
  std::optional<Estimate> yield, packing_penalty;
  /// The same by the comparison that verdicts come from, corrected for all groups; none below 6 rounds.
  std::optional<Change> yield_change, packing_change;

  [[nodiscard]] int cores() const { return one_each->cell.threads; }
};

/// One group for each cell that fills both hardware threads of all its cores and has its counterpart with
/// one thread a core. Where threads are not bound, where they run says nothing about where they could: such
/// cells are not looked at.
[[nodiscard]] std::vector<HyperThreadingGroup> hyper_threading_groups(const std::vector<CellRow>& rows);

/// Speedup against `serial` per hardware thread that its threads filled.
[[nodiscard]] std::optional<double> hardware_thread_efficiency(const CellRow& row);

/// For people: a row for each placement, with what it says in words.
[[nodiscard]] Table hyper_threading_table(const std::vector<CellRow>& rows,
                                          const std::vector<HyperThreadingGroup>& groups,
                                          const NoiseFloor& floor = {});

/// For programs: a row for each group.
[[nodiscard]] Table hyper_threading_data(const std::vector<HyperThreadingGroup>& groups);

}  // namespace raysweep
