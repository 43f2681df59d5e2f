// How small a difference comparisons find on this machine, and how often they find one that is not there:
// from a run with twins and planted slowdowns.
#pragma once

#include <vector>

#include "results/record.h"
#include "results/tables/table.h"

namespace raysweep {

/// Comparisons of a cell with its like, slowed down by a known share of each frame's time.
struct Detection {
  double planted;   // 0: the second twin, an A/A test
  int comparisons;  // blocks of rounds, one after the other
  int found;        // called slower; for an A/A test: called different at all

  /// found / comparisons
  [[nodiscard]] double share() const { return static_cast<double>(found) / comparisons; }
};

/// What comparisons of so many launches of either cell find.
struct Power {
  int launches;
  double noise_floor;  // median over comparisons, as a share: 0.01 for 1 %
  double
      measuring_seconds;  // of both cells and the twin that tells the noise floor: median, processes included
  std::vector<Detection> detections;  // by rising planted slowdown
};

/// For 7, 14, 28, … launches, as long as the rounds suffice for 20 comparisons. Each comparison is one
/// alone, not corrected for others, of the launches of its own rounds, as a run of that length would have
/// them; its noise floor is told by the first twin in the rounds before, as that of launches that are
/// themselves compared would be high just where they differ. Empty unless some cell of the run has two twins
/// and planted slowdowns.
[[nodiscard]] std::vector<Power> detection_power(const std::vector<Record>& records);

/// For people; the last line of the caption says what was found reliably, which is 80 times of 100.
[[nodiscard]] Table power_table(const std::vector<Power>& power);

/// For programs: one row a number of launches and planted slowdown.
[[nodiscard]] Table power_data(const std::vector<Power>& power);

}  // namespace raysweep
