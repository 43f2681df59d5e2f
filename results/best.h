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
  size_t comparisons = 0;      // that intervals and p of the largest group are corrected for
};

/// Groups are rows with the same picture, tracer and threads; what hands out the work differs (scheduler,
/// runtime, item, order, chunk, pin, wait policy, …). Intervals are corrected for all pairs of a group,
/// not only those with the best: which one is the best was read from the same launches. Corrected for the
/// comparisons with the best alone, equal cells would show a difference in 7 runs of 100 (6 cells, 7
/// launches) to 17 (27 cells, 28 launches); corrected for all pairs, in 1 to 3 (simulated, normal fps).
[[nodiscard]] Standings against_the_best(const std::vector<CellRow>& rows, const NoiseFloor& floor);

}  // namespace raysweep
