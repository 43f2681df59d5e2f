// The records of a pixels experiment, cell by cell.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "results/pixels_record.h"
#include "results/statistics/statistics.h"

namespace raysweep {

/// One cell: its errors, and what a ray of it takes.
struct PixelsRow {
  PixelsRecord first;  // of its first valid round, else of its first
  /// The median of the valid rounds' medians over frames, of one thread; none without a valid round.
  std::optional<Estimate> nanoseconds_per_ray;
  int void_rounds = 0;
  std::map<int, double> nanoseconds_by_round{};  // a ray, of valid rounds
};

/// Of those `cells`, by their keys, that there are records of, in their order.
[[nodiscard]] std::vector<PixelsRow> pixels_rows(const std::vector<PixelsRecord>& records,
                                                 const std::vector<std::string>& cells);

/// The folder of a pixels experiment, read back.
struct PixelsData {
  std::string experiment, title;
  std::vector<std::string> left_out;  // what was asked for and does not exist, each with its reason
  std::vector<PixelsRow> rows;
};

/// Reads plan.json and records.jsonl of `folder`. Throws RecordError where they are missing or not readable.
[[nodiscard]] PixelsData read_pixels_run(const std::filesystem::path& folder);

}  // namespace raysweep
