// The launches of a run, found by what they were of, and compared with others of the same round.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "results/record.h"
#include "results/statistics/statistics.h"

namespace raysweep {

/// Valid launches of one cell, by round.
using Rounds = std::map<int, const Record*>;

/// Names the cell of `r` itself, twins apart.
[[nodiscard]] std::string own_key(const Record& r);

/// The same cell launched once more in each round: its twin of this number, from 1.
[[nodiscard]] std::string twin_key(const Record& r, int twin = 1);

/// The cell that `r` is a twin of, or a slowed down one; else its own.
[[nodiscard]] std::string original_key(const Record& r);

/// One thread of the same scheduler.
[[nodiscard]] std::string one_thread_key(const Record& r);

/// The serial launches of the same picture, item shape and order, alone or `processes` at a time.
[[nodiscard]] std::string serial_key(const Record& r, int processes = 1);

/// The records of a run in order; they must outlive it.
class Launches {
 public:
  explicit Launches(const std::vector<Record>& records);

  /// Those of a cell by its name, void ones too.
  [[nodiscard]] std::vector<const Record*> of_cell(const std::string& cell) const;
  /// The valid ones of the cell that `key` names; empty if it has none.
  [[nodiscard]] const Rounds& valid(const std::string& key) const;

 private:
  std::map<std::string, std::vector<const Record*>> by_cell_;
  std::map<std::string, Rounds> by_key_;
};

/// The median of `value(of, base)` over the rounds that both have, where they were measured next to each
/// other; rounds for which it is none do not count. None without any.
template <class T, class Value>
std::optional<Estimate> paired(const std::map<int, T>& of, const std::map<int, T>& base, Value&& value) {
  std::vector<double> samples;
  for (const auto& [round, own] : of) {
    const auto other = base.find(round);
    if (other == base.end()) continue;
    if (const std::optional<double> sample = value(own, other->second)) samples.push_back(*sample);
  }
  if (samples.empty()) return std::nullopt;
  return estimate_median(std::move(samples));
}

}  // namespace raysweep
