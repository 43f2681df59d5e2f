// One row, measured in this process.
#pragma once

#include <string>
#include <vector>

#include "experiments/overhead/busy_work.h"
#include "experiments/overhead/row_samples.h"
#include "experiments/overhead/subject.h"

namespace raysweep {

/// What to measure.
struct RowParts {
  bool region = false;  // an empty region
  bool chunks = false;  // a run of many chunks of nothing, where chunks mean something
  bool sizes = false;   // runs of longer and longer tasks
  bool burn = false;    // what idle workers burn
};

struct RowRequest {
  Subject subject;
  RowParts parts;
  double seconds;         // for all of it, about
  double useful_at_once;  // min(threads, processors)
  WorkSpeed speed{};      // of busy work; 0: to be found out
};

/// `benchmark_flags` are Google Benchmark's own, "--benchmark_…"; they win over what is asked for here.
/// Throws RequestError for a flag that it does not know, SchedulerError if there is no such scheduler.
[[nodiscard]] RowSamples measure_row(const RowRequest& request,
                                     const std::vector<std::string>& benchmark_flags);

}  // namespace raysweep
