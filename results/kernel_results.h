// The records of a kernel experiment, ready to be asked: pure functions of them.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "results/accuracy_results.h"
#include "results/kernel_record.h"
#include "results/statistics/statistics.h"

namespace raysweep {

/// Nanoseconds a test, the median of a record's samples, which must be there.
[[nodiscard]] double nanoseconds_a_test(const KernelRecord& record);

/// Over rounds. Not for none.
[[nodiscard]] Estimate median_of(const std::map<int, double>& by_round);

/// "random", "hit-rate 0.3", "replay chair-ball", "clusters 64, tbb_auto, 2 threads": what was tested, and by
/// whom.
[[nodiscard]] std::string tests_of(const KernelRecord& record);

/// A kernel on a list of tests, or in one of its ways, over all rounds.
struct KernelCellResult {
  KernelRecord record;                  // the first, for all that is the same in each
  std::optional<Estimate> nanoseconds;  // a test: median over rounds; none without a valid record
  int void_rounds = 0;                  // records that are not valid
  std::string reason;                   // of the first of them
  std::map<int, double> by_round;       // nanoseconds of valid records
  // Of kernels that time every operation: ticks by round; the statistics are min, avg, max and sum.
  std::map<std::string, std::map<int, double>> ticks;
};

/// A kernel against the base kernel of its method on the same tests: below 1 it is faster. The median over
/// rounds that have both; none without any.
struct KernelRatio {
  Estimate estimate;

  /// Whether the interval, of 95 % for this ratio alone, leaves out 1. Never without one.
  [[nodiscard]] bool shows_difference() const;
};

class KernelResults {
 public:
  explicit KernelResults(const std::vector<KernelRecord>& records);

  /// Whether these are tests of rays; other kernels have cells alone: no methods, precisions and tests.
  [[nodiscard]] bool are_intersection() const { return !methods_.empty() || cells_.empty(); }

  // All of these in the order in which the records name them first.
  [[nodiscard]] const std::vector<KernelCellResult>& cells() const { return cells_; }
  [[nodiscard]] const std::vector<std::string>& methods() const { return methods_; }
  [[nodiscard]] const std::vector<std::string>& precisions() const { return precisions_; }
  /// As `tests_of` tells them.
  [[nodiscard]] const std::vector<std::string>& tests() const { return tests_; }

  /// Null if it has not been run.
  [[nodiscard]] const KernelCellResult* find(const std::string& method, const std::string& change,
                                             const std::string& precision, const std::string& tests) const;
  [[nodiscard]] std::optional<KernelRatio> against_base(const KernelCellResult& cell) const;

 private:
  /// The cell of a record, new or there already.
  [[nodiscard]] KernelCellResult& cell_of(const KernelRecord& record);

  std::vector<KernelCellResult> cells_;
  std::map<std::string, size_t> index_;
  std::vector<std::string> methods_, precisions_, tests_;
};

/// The folder of a kernel experiment, read back.
struct KernelData {
  std::string experiment, title;
  int rounds = 0;    // asked for
  size_t cells = 0;  // planned
  std::vector<LeftOutVariant> left_out;
  KernelResults results;
};

/// Reads plan.json and records.jsonl of `folder`; cells in the order of the plan. Throws RecordError where
/// they are missing or not readable.
[[nodiscard]] KernelData read_kernel_run(const std::filesystem::path& folder);

}  // namespace raysweep
