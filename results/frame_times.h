// How long frames take, the slow ones too.
#pragma once

#include <optional>
#include <vector>

#include "results/resampling.h"

namespace raysweep {

/// Of all frames of all launches together, in seconds. Quantiles are those of `quantile`.
struct FrameTimes {
  int launches = 0, frames = 0;
  double p5 = 0, max = 0;
  Estimate p50, p95;           // with intervals by the hierarchical bootstrap, from 6 launches on
  std::optional<double> p99;   // from 100 frames on: of fewer it would be the largest, more or less
  std::optional<double> cold;  // the first frame of a process, before any warm-up: median over launches
};

/// None without a frame.
[[nodiscard]] std::optional<FrameTimes> frame_times(const FramesByLaunch& frames,
                                                    const std::vector<double>& cold_seconds);

}  // namespace raysweep
