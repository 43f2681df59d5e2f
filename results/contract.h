// What each method of intersection promises, and what it is expected to fail: counts of failures on every
// case, recorded once, and how a run compares with them.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "results/accuracy_results.h"

namespace raysweep {

/// The counts of a record that a contract states, in this order.
inline constexpr std::array<std::string_view, 4> failure_names = {"false_misses", "false_hits", "missed_rays",
                                                                  "nonfinite"};
[[nodiscard]] std::array<uint64_t, 4> failure_counts(const AccuracyRecord& record);

/// k, if 99 of 100 of a record's errors of t are at most 2^k ε, k the least that is not negative;
/// `unstated` of fewer than a hundred hits, whose 99th percentile is their worst one.
inline constexpr int unstated = -1;
[[nodiscard]] int t_error_class(const AccuracyRecord& record);

/// What one method promises in one variant and precision on one case: of `rays` rays drawn from `seed` so
/// many fail, level by level. It fails at a level if one ray does, and without any its share of failures is
/// at most 3/rays, at 95 %.
struct Clause {
  std::string method, change, precision, case_id;
  uint64_t seed = 0, rays = 0;
  std::array<std::vector<uint64_t>, 4> failures;  // by `failure_names`, then by level
  std::vector<int> t_error_classes;               // by level
};

/// Clauses in the order of a file. A variant without one promises what its method's base variant does, as
/// most do: such a clause is left out when a contract is made.
class Contract {
 public:
  /// What a run with every level of its cases would promise. Throws std::invalid_argument where one lacks.
  explicit Contract(const AccuracyResults& results);
  /// Reads a file as `to_csv` writes it. Throws RecordError where there is none or it is none.
  [[nodiscard]] static Contract read(const std::filesystem::path& file);

  [[nodiscard]] const std::vector<Clause>& clauses() const { return clauses_; }
  /// The clause that binds the variant of the record; null if none does. How products and sums are contracted
  /// is the compiler's choice from place to place: nothing is promised of it, nor of several changes at once.
  [[nodiscard]] const Clause* clause_of(const AccuracyRecord& record) const;

 private:
  using Key = std::tuple<std::string, std::string, std::string, std::string>;
  Contract() = default;
  void add(Clause clause);

  std::vector<Clause> clauses_;
  std::map<Key, size_t> index_;
};

/// One line a clause; the numbers of levels are separated by spaces, "never" stands for nothing but zeros.
[[nodiscard]] std::string to_csv(const Contract& contract);

enum class Outcome { kept, broken, better };
[[nodiscard]] std::string_view name_of(Outcome outcome);

/// One number of a record beside what was promised.
struct Judgement {
  std::string_view what;  // of `failure_names`, or "t_error"
  int64_t stated = 0, found = 0;
  Outcome outcome{};
};

/// All that the clause states of the record's level; empty if it does not know the level, or the record has
/// another seed: that draws other meshes, of which some are harder. With the clause's own number of rays
/// every difference counts, unless an estimate of 1/det is the processor's own. Else rays break a promise if
/// failures are more than twice as frequent, and by five standard deviations; likewise better; of classes of
/// t two make a difference.
[[nodiscard]] std::vector<Judgement> judge(const AccuracyRecord& record, const Clause& clause);

}  // namespace raysweep
