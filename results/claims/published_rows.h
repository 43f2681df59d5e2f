// What was printed beside what was measured.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/claims/published_table.h"

namespace raysweep {

struct PublishedRow {
  Factors factors;      // of the printed number, and those in which ours of it differ
  std::string printed;  // as it was
  std::optional<double> printed_normalised;
  std::optional<Estimate> ours;             // in the quantity's unit; none: not measured here
  std::optional<Estimate> ours_normalised;  // its interval from rounds drawn together
};

/// One row a printed number, in the order of the table; where ours have more than one number for it, the
/// whole table once for each of them. Normalised: each column, ours too, by its own first line.
[[nodiscard]] std::vector<PublishedRow> published_rows(const PublishedTable& table,
                                                       const std::vector<Observation>& ours);

}  // namespace raysweep
