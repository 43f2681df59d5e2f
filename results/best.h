// Which of the cells that render the same picture with as many threads is the fastest.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/comparison.h"
#include "results/scaling.h"

namespace raysweep {

/// How a row stands against the one with the highest median fps of its group.
struct Standing {
  enum class Place { alone, best, other } place = Place::alone;
  bool shown = false;            // of the best: that all others are slower
  std::optional<Change> change;  // of the others: their fps by the best's, paired by round
  std::optional<double> adjusted_p;
  Verdict verdict = Verdict::too_few;

  /// "fastest", "best median", "slower by 3.1 % [2.0, 4.3]", "no difference shown"; empty where it is alone.
  [[nodiscard]] std::string to_text(const NoiseFloor& floor) const;
};

struct Standings {
  std::vector<Standing> rows;  // one a row, in their order
  size_t comparisons = 0;      // that intervals and p are corrected for
};

/// Groups are rows with the same picture, tracer and threads; what hands out the work differs (scheduler,
/// runtime, item, order, chunk, pin, wait policy, …). Intervals are corrected for all pairs of all groups,
/// not only those with the best: which one is the best was read from the same launches, and with six equal
/// cells of 7 launches the correction for five comparisons finds a difference in 10 runs of 100, that for all
/// fifteen in 4 (simulated).
[[nodiscard]] Standings against_the_best(const std::vector<CellRow>& rows, const NoiseFloor& floor);

}  // namespace raysweep
