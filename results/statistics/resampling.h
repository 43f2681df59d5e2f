// The bootstrap over launches and their frames: intervals of statistics that have no formula.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "results/statistics/statistics.h"

namespace raysweep {

/// Times of frames, by launch.
using FramesByLaunch = std::vector<std::vector<double>>;
/// Several numbers of one sample, so that they share its resamples.
using Statistics = std::function<std::vector<double>(const FramesByLaunch&)>;

inline constexpr size_t fewest_launches = 6;  // as for medians: fewer have no 95 % interval

/// 95 % intervals of `statistics`, in their order, or nothing for fewer than 6 launches. Launches are drawn
/// with replacement, then as many frames of each: frames of a launch resemble each other, so that the launch
/// is the sample (Davison & Hinkley 1997, 3.8; Kalibera & Jones 2013). The interval's ends are percentiles of
/// 2,000 resamples (of more than 2,000 frames: fewer, 400 at least), further out the fewer launches there
/// are: those of Φ(±√(n/(n−1))·t) with t the 97.5 % quantile of Student's distribution with n − 1 degrees of
/// freedom (Hesterberg 2015, "What teachers should know about the bootstrap", 5.3: plain percentiles are too
/// narrow by what √((n−1)/n) and the normal distribution leave out). The same seed gives the same intervals
/// everywhere.
[[nodiscard]] std::vector<Estimate::Bounds> hierarchical_bootstrap(const FramesByLaunch& frames,
                                                                   const Statistics& statistics,
                                                                   uint64_t seed = 1);

/// The same for one number; none for fewer than 6 launches.
[[nodiscard]] std::optional<Estimate::Bounds> hierarchical_bootstrap(
    const FramesByLaunch& frames, const std::function<double(const FramesByLaunch&)>& statistic,
    uint64_t seed = 1);

/// The same of a statistic of whole samples, told by their places: `count` of them are drawn with
/// replacement, 2,000 times. `fewest` is how many the scarcest of the numbers in it have: the interval is as
/// wide as so many ask for. Draws for which the statistic is none are drawn again; none for fewer than 6.
[[nodiscard]] std::optional<Estimate::Bounds> bootstrap_places(
    size_t count, size_t fewest,
    const std::function<std::optional<double>(const std::vector<size_t>&)>& statistic, uint64_t seed = 1);

}  // namespace raysweep
