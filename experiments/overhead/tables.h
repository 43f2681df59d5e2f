// Rows as tables: for people, and as numbers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/overhead/busy_work.h"
#include "experiments/overhead/metg.h"
#include "experiments/overhead/row_samples.h"
#include "experiments/overhead/subject.h"
#include "results/statistics/statistics.h"
#include "results/tables/table.h"

namespace raysweep {

struct OverheadRow {
  Subject subject;
  RowSamples samples{};
  WorkSpeed before{}, after{};  // of busy work, on one thread, alone
  std::string problem{};        // why there are no samples
};

/// What one chunk costs in time of a processor, in nanoseconds: what a run of many takes longer than an empty
/// region, times `useful_at_once`, over their count. The interval is that of the difference's two ends, so it
/// is too wide rather than too narrow. None where either was not measured.
[[nodiscard]] std::optional<Estimate> nanoseconds_per_chunk(const RowSamples& samples, double useful_at_once);

/// Task sizes in time, by the mean of both calibrations.
[[nodiscard]] std::vector<TaskSize> task_sizes(const OverheadRow& row, int processors);

/// Tables name the machine's count of processors: what exceeds it is marked as oversubscribed.
[[nodiscard]] Table scheduler_table(const std::vector<OverheadRow>& rows, int processors);
[[nodiscard]] Table waiting_table(const std::vector<OverheadRow>& rows, int processors);

/// All times in nanoseconds; cells of what was not measured are empty.
[[nodiscard]] Table scheduler_numbers(const std::vector<OverheadRow>& rows, int processors);
[[nodiscard]] Table task_size_numbers(const std::vector<OverheadRow>& rows, int processors);
[[nodiscard]] Table waiting_numbers(const std::vector<OverheadRow>& rows, int processors);

}  // namespace raysweep
