#include "results/statistics/resampling.h"

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "results/statistics/random.h"

namespace raysweep {

namespace {

/// Which share of resamples to leave out at each end.
double expanded_tail(size_t launches) {
  const double n = static_cast<double>(launches);
  const double t = quantile(boost::math::students_t(n - 1), 0.975);
  return cdf(boost::math::normal(), -std::sqrt(n / (n - 1)) * t);
}

/// Fills `drawn`, which has as many launches as `frames`.
void resample(const FramesByLaunch& frames, Random& random, FramesByLaunch& drawn) {
  for (auto& launch : drawn) {
    const auto& from = frames[random.index(frames.size())];
    launch.resize(from.size());
    for (double& frame : launch) frame = from[random.index(from.size())];
  }
}

}  // namespace

std::vector<Estimate::Bounds> hierarchical_bootstrap(const FramesByLaunch& frames,
                                                     const Statistics& statistics, uint64_t seed) {
  if (frames.size() < fewest_launches) return {};
  // With 6 launches the ends lie between the fifth and the sixth of 2,000 from outside. Fewer resamples are
  // enough where there are so many frames that their number is what it costs.
  constexpr size_t most = 2000, fewest = 400, draws = 4'000'000;
  size_t frame_count = 1;
  for (const auto& launch : frames) frame_count += launch.size();
  const size_t resamples = std::clamp(draws / frame_count, fewest, most);
  Random random(seed);
  FramesByLaunch drawn(frames.size());
  std::vector<std::vector<double>> values(statistics(frames).size());
  for (size_t i = 0; i < resamples; ++i) {
    resample(frames, random, drawn);
    const auto numbers = statistics(drawn);
    for (size_t s = 0; s < values.size(); ++s) values[s].push_back(numbers[s]);
  }
  const double tail = expanded_tail(frames.size());
  std::vector<Estimate::Bounds> intervals;
  for (const auto& of_one : values) intervals.push_back({quantile(of_one, tail), quantile(of_one, 1 - tail)});
  return intervals;
}

std::optional<Estimate::Bounds> hierarchical_bootstrap(
    const FramesByLaunch& frames, const std::function<double(const FramesByLaunch&)>& statistic,
    uint64_t seed) {
  const auto one = [&](const FramesByLaunch& drawn) { return std::vector{statistic(drawn)}; };
  const auto intervals = hierarchical_bootstrap(frames, Statistics(one), seed);
  return intervals.empty() ? std::nullopt : std::optional(intervals.front());
}

std::optional<Estimate::Bounds> bootstrap_places(
    size_t count, size_t fewest,
    const std::function<std::optional<double>(const std::vector<size_t>&)>& statistic, uint64_t seed) {
  if (fewest < fewest_launches) return std::nullopt;
  constexpr size_t resamples = 2000, most_draws = 10 * resamples;
  Random random(seed);
  std::vector<size_t> drawn(count);
  std::vector<double> values;
  for (size_t i = 0; i < most_draws && values.size() < resamples; ++i) {
    for (size_t& place : drawn) place = random.index(count);
    if (const auto value = statistic(drawn)) values.push_back(*value);
  }
  if (values.size() < resamples) return std::nullopt;
  const double tail = expanded_tail(fewest);
  return Estimate::Bounds{quantile(values, tail), quantile(values, 1 - tail)};
}

}  // namespace raysweep
