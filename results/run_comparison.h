// Whether one run is faster than another, cell by cell; and one cell of a run than another.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "results/comparison.h"
#include "results/run_data.h"

namespace raysweep {

/// How a cell of B stands against its counterpart in A.
struct CellComparison {
  Record cell;       // for its factors
  std::string name;  // "thread_static, 2 threads", with the other factors that vary
  std::optional<Estimate> fps_a, fps_b;
  std::optional<Change> change;  // fps of B by fps of A
  std::optional<double> adjusted_p;
  Verdict verdict = Verdict::too_few;
  std::string not_compared;  // why it is not: only in one run, another picture
};

struct RunComparison {
  std::vector<CellComparison> rows;
  std::vector<std::string> warnings;  // what makes the whole comparison doubtful
  std::string sentence;               // the verdict
  NoiseFloor floor;
  bool same_machine = true;

  /// Whether a cell of B is shown to be slower, and by more than `share` of A's fps (0.03 for 3 %) at best
  /// guess.
  [[nodiscard]] bool slower_than(double share) const;
  /// Why that cannot be said of every cell of A: a sentence; empty if it can.
  [[nodiscard]] std::string unanswered() const;
};

/// Runs made at different times: cells with the same factors are compared by the trimmed means of their
/// launches' log fps, unpaired and corrected for all cells; the floor is the larger of the two runs', unknown
/// where either is. Cells with different pictures, or in one run only, are told and not compared.
[[nodiscard]] RunComparison compare_runs(const RunData& a, const RunData& b);

/// Two cells of one run, B against A, paired by round.
[[nodiscard]] RunComparison compare_cells(const RunData& run, const CellRow& a, const CellRow& b);

/// For people.
[[nodiscard]] Table comparison_table(const RunComparison& comparison);
/// For programs: unrounded, every factor.
[[nodiscard]] Table comparison_data(const RunComparison& comparison);
/// {"sentence", "warnings", "noise_floor" (a log ratio), "rows": [one object a row, keyed by column of the
/// data]}
[[nodiscard]] nlohmann::json comparison_as_json(const RunComparison& comparison);

}  // namespace raysweep
