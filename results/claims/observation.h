// What claims are asked of: one number of one cell, measured or printed.
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "results/statistics/statistics.h"

namespace raysweep {

/// Values of factors as texts, by the factors' names.
using Factors = std::map<std::string, std::string>;

struct Observation {
  Factors factors;
  std::map<int, double> by_round;  // one sample a round; empty for what is printed, and what is exact
  Estimate value;                  // a count of 0: planned, but not measured
  bool exact = false;              // the same whenever it is taken: it has no noise
  double half_unit = 0;            // of the last digit, of what is printed
};

/// By quantity: "fps", "nanoseconds".
using Observations = std::map<std::string, std::vector<Observation>>;

/// One row of a run: all that is known of a cell.
struct MeasuredCell {
  std::string cell;  // its name
  Factors factors;
  std::map<std::string, Observation> values;  // by quantity; their factors are left empty
  std::vector<std::string> notes{};
  bool oversubscribed = false;
};

/// A sample a round, summarised by its median.
[[nodiscard]] Observation observation_of(std::map<int, double> by_round);

/// A number without noise.
[[nodiscard]] Observation exact_observation(double value);

/// The cells' values by quantity, each with its cell's factors.
[[nodiscard]] Observations observations_of(const std::vector<MeasuredCell>& cells);

/// The number that a value of a factor begins with, "3/thread" with 3; none for a name.
[[nodiscard]] std::optional<double> leading_number(const std::string& text);

/// Whether all of it is a number.
[[nodiscard]] bool is_number(const std::string& text);

/// Whether two values of a factor are the same: as texts, or as numbers where both are numbers.
[[nodiscard]] bool is_same_value(const std::string& a, const std::string& b);

/// Below: in the order of numbers where both begin with one, else as texts.
[[nodiscard]] bool is_value_before(const std::string& a, const std::string& b);

}  // namespace raysweep
