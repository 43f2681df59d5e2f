#include "results/frame_times.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace raysweep {

namespace {

constexpr int fewest_for_p99 = 100;

std::vector<double> sorted_frames(const FramesByLaunch& frames) {
  std::vector<double> all;
  for (const auto& launch : frames) all.insert(all.end(), launch.begin(), launch.end());
  std::ranges::sort(all);
  return all;
}

/// The same frames as ranks among all of them: resamples of ranks are sorted by counting.
FramesByLaunch to_ranks(FramesByLaunch frames, const std::vector<double>& sorted) {
  for (auto& launch : frames) {
    for (double& frame : launch)
      frame = static_cast<double>(std::ranges::lower_bound(sorted, frame) - sorted.begin());
  }
  return frames;
}

/// The median and the 95 % quantile of a resample of ranks, as seconds.
class Quantiles {
 public:
  explicit Quantiles(const std::vector<double>& sorted) : sorted_(sorted), counts_(sorted.size()) {}

  std::vector<double> operator()(const FramesByLaunch& ranks) {
    std::ranges::fill(counts_, 0u);
    size_t count = 0;
    for (const auto& launch : ranks) {
      for (const double rank : launch) counts_[static_cast<size_t>(rank)]++;
      count += launch.size();
    }
    return {quantile_of(count, 0.5), quantile_of(count, 0.95)};
  }

 private:
  [[nodiscard]] double quantile_of(size_t count, double share) const {
    const double position = share * (static_cast<double>(count) - 1);
    const auto below = static_cast<size_t>(position);
    const double part = position - static_cast<double>(below);
    size_t rank = 0, seen = counts_[0];
    const auto advance = [&](size_t to) {
      while (seen <= to) seen += counts_[++rank];
      return sorted_[rank];
    };
    const double value = advance(below);
    return part > 0 ? value + part * (advance(below + 1) - value) : value;
  }

  const std::vector<double>& sorted_;
  std::vector<unsigned> counts_;
};

}  // namespace

double effective_frames(const FramesByLaunch& frames) {
  const auto mean = [](const std::vector<double>& list) {
    return std::accumulate(list.begin(), list.end(), 0.0) / static_cast<double>(list.size());
  };
  const auto launches = static_cast<double>(frames.size());
  const double all_mean = mean(sorted_frames(frames));
  double count = 0, counts_squared = 0, between = 0, within = 0;
  for (const auto& launch : frames) {
    const auto size = static_cast<double>(launch.size());
    const double own = mean(launch);
    count += size;
    counts_squared += size * size;
    between += size * (own - all_mean) * (own - all_mean);
    for (const double frame : launch) within += (frame - own) * (frame - own);
  }
  if (launches < 2 || count <= launches) return launches;
  const double size = (count - counts_squared / count) / (launches - 1);  // of launches that differ in size
  between /= launches - 1;
  within /= count - launches;
  const double total = between + (size - 1) * within;
  const double correlation = total > 0 ? std::max(0.0, (between - within) / total) : 0;
  return count / (1 + (count / launches - 1) * correlation);
}

std::optional<FrameTimes> frame_times(const FramesByLaunch& frames, const std::vector<double>& cold_seconds) {
  const auto sorted = sorted_frames(frames);
  if (sorted.empty()) return std::nullopt;
  FrameTimes times;
  times.launches = static_cast<int>(frames.size());
  times.frames = static_cast<int>(sorted.size());
  times.p5 = quantile(sorted, 0.05);
  times.max = sorted.back();
  times.p50 = {quantile(sorted, 0.5), std::nullopt, times.frames};
  times.p95 = {quantile(sorted, 0.95), std::nullopt, times.frames};
  if (times.frames >= fewest_for_p99) times.p99 = quantile(sorted, 0.99);
  if (!cold_seconds.empty()) times.cold = median(cold_seconds);

  Quantiles quantiles(sorted);
  const auto intervals = hierarchical_bootstrap(to_ranks(frames, sorted), Statistics(std::ref(quantiles)));
  if (!intervals.empty()) {
    times.p50.interval = intervals[0];
    if (effective_frames(frames) >= fewest_effective_frames) times.p95.interval = intervals[1];
  }
  return times;
}

}  // namespace raysweep
