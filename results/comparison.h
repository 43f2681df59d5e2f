// Whether one of two is faster: robust comparisons of their fps, corrected for how many there are.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "results/noise_floor.h"
#include "results/statistics/statistics.h"

namespace raysweep {

/// How many times as fast: exp of the 20 % trimmed mean of log ratios.
struct Change {
  double ratio = 1;
  Estimate::Bounds interval{1, 1};  // of the ratio, at the confidence asked for
  double p = 1;                     // of a ratio as far from 1, were there no difference
  int count = 0;                    // pairs, or samples of the smaller side
};

inline constexpr double usual_confidence = 0.95;

/// From log ratios of pairs. The fifth at each end is trimmed, and the standard error is that of the
/// winsorised samples (Tukey & McLaughlin 1963), so that one slow launch of seven neither moves the mean nor
/// hides a difference. With h samples left the statistic is held against Student's distribution with 0.85 (h
/// − 1) degrees of freedom: with their h − 1, 5.8 % of normal samples of 6 to 10 pairs would differ from 0 at
/// the 5 % level, and 1.4 % at the 1 % level (simulated, 10⁶ samples each; Patel, Mudholkar & Fernando 1988
/// adjust likewise). The signed-rank test would be exact, but with 7 pairs its p never goes below 2/128:
/// corrected for four comparisons it could show nothing. None below 6 pairs.
[[nodiscard]] std::optional<Change> paired_change(const std::vector<double>& log_ratios,
                                                  double confidence = usual_confidence);

/// Of fps by round: ln(own/base) of each round that both have, where they were measured next to each other.
[[nodiscard]] std::vector<double> log_ratios(const std::map<int, double>& own,
                                             const std::map<int, double>& base);

/// Of two lists of logs that were not measured side by side: Yuen 1974 with Welch's degrees of freedom, which
/// are reduced by the same 0.85. None below 6 samples on either side.
[[nodiscard]] std::optional<Change> unpaired_change(const std::vector<double>& logs,
                                                    const std::vector<double>& base_logs,
                                                    double confidence = usual_confidence);

/// p values of a family of comparisons, adjusted by Holm 1979: compared with 0.05, the chance of any false
/// difference in the whole family stays below 5 %. In the order of `p`.
[[nodiscard]] std::vector<double> holm(const std::vector<double>& p);

/// The confidence of each of `comparisons` intervals that hold together 95 times of 100 (Bonferroni). An
/// interval that excludes 1 has an adjusted p below 0.05; not the other way round, as Holm's p are a little
/// sharper.
[[nodiscard]] double simultaneous_confidence(size_t comparisons);

enum class Verdict { faster, slower, no_difference, too_few };

/// Faster or slower only if the interval excludes 1 and the effect exceeds the floor, where one is known.
[[nodiscard]] Verdict verdict_of(const std::optional<Change>& change, const NoiseFloor& floor);

/// "faster", "slower", "no difference", "too few"
[[nodiscard]] std::string to_string(Verdict verdict);

/// Whether the interval excludes 1.
[[nodiscard]] bool excludes_one(const Change& change);

}  // namespace raysweep
