// One launch, inside its own process: warm up, render, time, report.
#pragma once

#include <functional>
#include <vector>

#include "experiments/cell.h"
#include "results/record.h"

namespace raysweep {

struct LaunchOptions {
  double seconds = 0.3;                       // timed frames go on for so long; at least one
  bool timed = true;                          // false: one frame only, for its picture
  std::function<void()> before_timing;        // called between warm-up and timing
  std::function<bool()> keep_busy;            // after timing: render on while this is true
  std::function<void(const Record&)> report;  // called once, before keep_busy
};

/// Whether the last of `frames`, in seconds, is no longer clearly faster than the fastest before it.
[[nodiscard]] bool has_settled(const std::vector<double>& frames);

/// Runs `cell` once; its record lacks what only the run knows (experiment, round, machine). Throws SceneError
/// or SchedulerError.
void run_launch(const Cell& cell, const LaunchOptions& options);

}  // namespace raysweep
