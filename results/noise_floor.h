// What comparing a cell with itself shows: effects below it say nothing.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/rounds.h"

namespace raysweep {

struct NoiseFloor {
  std::optional<double> log_ratio;  // none: unknown
  int pairs = 0;                    // that it comes from

  /// The log ratio that an effect must exceed. Where no floor is known, that of the clock: what is below 10⁻⁸
  /// (a nanosecond of 0.1 s) is rounding.
  [[nodiscard]] double least_effect() const;
  /// "noise floor: 0.8 % (A/A of 7 pairs)", "noise floor unknown: no A/A pairs"
  [[nodiscard]] std::string to_text() const;
};

/// The effect that comparing a cell with itself by the trimmed mean of `launches` pairs stays under 95 times
/// of 100. Pairs of the size asked for are drawn from `log_ratios`, each with a random sign (which of two
/// equal launches is the first is chance), 10,000 times; the fewer pairs there are to draw from, the wider,
/// by Student's quantile over the normal one. Unknown below 6 pairs.
[[nodiscard]] NoiseFloor noise_floor(const std::vector<double>& log_ratios, int launches, uint64_t seed = 1);

/// Log ratios of fps of the first twins in a run, each against the launch of its cell in the same round.
[[nodiscard]] std::vector<double> twin_log_ratios(const std::vector<Record>& records);

/// The floor of a run: for comparisons of as many launches as its least launched cell has. Cells that did not
/// converge have more, and smaller effects of theirs would be above the noise; they count as below it.
[[nodiscard]] NoiseFloor noise_floor(const std::vector<Record>& records);

}  // namespace raysweep
