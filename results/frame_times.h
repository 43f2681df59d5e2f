// How long frames take, the slow ones too.
#pragma once

#include <optional>
#include <vector>

#include "results/statistics/resampling.h"

namespace raysweep {

/// Of all frames of all launches together, in seconds. Quantiles are those of `quantile`.
struct FrameTimes {
  int launches = 0, frames = 0;
  double p5 = 0, max = 0;
  Estimate p50;                // with an interval by the hierarchical bootstrap, from 6 launches on
  Estimate p95;                // likewise, but only from 72 effective frames on
  std::optional<double> p99;   // from 100 frames on: of fewer it would be the largest, more or less
  std::optional<double> cold;  // the first frame of a process, before any warm-up: median over launches
};

/// How many independent frames these are worth: n/(1 + (m − 1)ρ) for n frames, m a launch, with the
/// correlation ρ within launches by analysis of variance (Fisher 1925; Kish 1965, "Survey Sampling", 5.4).
/// The number of launches where each has one frame.
[[nodiscard]] double effective_frames(const FramesByLaunch& frames);

/// With fewer all are below the 95 % quantile more often than 2.5 times of 100 (0.95⁷² = 0.025), and an
/// interval from resamples cannot reach it: simulated with 7 launches of one frame each it covered it 28
/// times of 100.
inline constexpr double fewest_effective_frames = 72;

/// None without a frame.
[[nodiscard]] std::optional<FrameTimes> frame_times(const FramesByLaunch& frames,
                                                    const std::vector<double>& cold_seconds);

}  // namespace raysweep
