// What a paper printed, as observations: the table beside which ours stand.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "results/claims/expression.h"
#include "results/claims/observation.h"

namespace raysweep {

/// A number as it was printed, and of what.
struct PrintedNumber {
  Factors factors;
  std::string text;
};

struct PublishedTable {
  std::string file;                    // as the config names it
  std::string quantity;                // what its numbers are
  double scale = 1;                    // from what was printed to the quantity's unit
  std::vector<std::string> rows;       // factors of its lines
  std::string normalise = "none";      // or "first_row": how it is put beside ours
  MachineCounts machine;               // that it was printed of
  std::vector<PrintedNumber> numbers;  // line by line
};

/// How a table's lines and columns say what their numbers are of.
struct PublishedLayout {
  std::vector<std::string> rows;          // factors that the first columns are
  std::string row_values = "{}";          // what the first one stands for: "{}/thread"
  std::vector<std::string> columns;       // factors whose values the other heads are, joined by "_"
  std::map<std::string, Factors> rename;  // heads that are no plain values
  Factors factors;                        // of all numbers
};

/// The numbers of a CSV file; empty fields are left out. Throws RecordError, with file and line, for what is
/// no such table, or has columns that the layout cannot name.
[[nodiscard]] std::vector<PrintedNumber> read_published(const std::filesystem::path& file,
                                                        const PublishedLayout& layout,
                                                        const std::string& quantity);

/// In the quantity's unit, each with half a unit of its last printed digit. Of numbers that are printed twice
/// for the same factors the first counts. A table of fps is one of frame_seconds too, and the other way
/// round; none of other quantities than it prints.
[[nodiscard]] std::optional<std::vector<Observation>> observations_of(const PublishedTable& table,
                                                                      const std::string& quantity);

/// Half a unit of the last digit: 0.0005 of "6.888", 0.5 of "36".
[[nodiscard]] double half_unit_of(const std::string& printed);

}  // namespace raysweep
