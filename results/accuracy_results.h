// The records of an accuracy experiment, ready to be asked: pure functions of them.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "results/accuracy_record.h"

namespace raysweep {

/// How many of so many went wrong.
struct Failures {
  uint64_t count = 0, of = 0;
};
/// Of the oracle's hits those that were missed; of its misses those that were hit; of rays at a mesh that the
/// oracle does not see pass those that no triangle stopped.
[[nodiscard]] Failures false_misses(const AccuracyRecord& record);
[[nodiscard]] Failures false_hits(const AccuracyRecord& record);
[[nodiscard]] Failures missed_rays(const AccuracyRecord& record);

/// Whether anything of it is wrong: one of these three, or a number that is not finite.
[[nodiscard]] bool has_failed(const AccuracyRecord& record);

/// A variant that was asked for, which its method does not have, and why not.
struct LeftOutVariant {
  std::string method, change, precision, reason;
};

class AccuracyResults {
 public:
  explicit AccuracyResults(std::vector<AccuracyRecord> records);

  /// In the order in which the records name them first.
  [[nodiscard]] const std::vector<std::string>& methods() const { return methods_; }
  [[nodiscard]] const std::vector<std::string>& cases() const { return cases_; }
  [[nodiscard]] const std::vector<std::string>& precisions() const { return precisions_; }
  [[nodiscard]] const std::vector<AccuracyRecord>& records() const { return records_; }

  /// Null if it has not been run.
  [[nodiscard]] const AccuracyRecord* find(const std::string& method, const std::string& change,
                                           const std::string& precision, const std::string& case_id,
                                           int level) const;
  /// The levels of a case that were run, from easy to hard.
  [[nodiscard]] std::vector<int> levels(const std::string& case_id) const;

 private:
  using Key = std::tuple<std::string, std::string, std::string, std::string, int>;

  std::vector<AccuracyRecord> records_;
  std::map<Key, size_t> index_;
  std::map<std::string, std::vector<int>> levels_;
  std::vector<std::string> methods_, cases_, precisions_;
};

/// The folder of an accuracy experiment, read back.
struct AccuracyData {
  std::string experiment, title;
  uint64_t rays = 0;  // of each cell
  std::vector<LeftOutVariant> left_out;
  AccuracyResults results;
};

/// The kind of the run in `folder`: "picture", "accuracy", "kernel" or "pixels". Throws RecordError where
/// there is no run.
[[nodiscard]] std::string run_kind(const std::filesystem::path& folder);

/// Reads plan.json and records.jsonl of `folder`. Throws RecordError where they are missing or not readable.
[[nodiscard]] AccuracyData read_accuracy_run(const std::filesystem::path& folder);

}  // namespace raysweep
