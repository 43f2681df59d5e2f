// Two ways to do the same, measured in turns.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "results/statistics/statistics.h"

namespace raysweep {

/// One round: nanoseconds of a chunk in each way.
struct Round {
  double direct, ours;
};

/// Medians over rounds, with 95 % order-statistic intervals; difference and ratio are taken within rounds, so
/// that what disturbs both for a while cancels.
struct Comparison {
  Estimate direct, ours;
  Estimate difference;  // ours − direct
  Estimate ratio;       // ours / direct
};

/// Not for an empty list.
[[nodiscard]] Comparison compare(const std::vector<Round>& rounds);

/// What is claimed of our interface: a chunk costs at most 2 % more than by hand, or at most 10 ns: next to
/// tiles of a hundred microseconds and more, 10 ns are less than a ten-thousandth.
inline constexpr double claimed_ratio = 1.02, claimed_nanoseconds = 10;

enum class OverheadVerdict { holds, does_not_hold, undecided };

/// Holds if one of the intervals is within its claim, fails if both are beyond.
[[nodiscard]] OverheadVerdict judge(const Comparison& comparison);
[[nodiscard]] std::string_view text(OverheadVerdict verdict);

/// Calls both in turns, direct first in even rounds and second in odd ones, so that neither always inherits
/// what the other leaves behind. Each returns nanoseconds of a chunk. One more round before is thrown away.
[[nodiscard]] std::vector<Round> take_turns(const std::function<double()>& direct,
                                            const std::function<double()>& ours, int rounds);

}  // namespace raysweep
