// A run's folder, read back: all that tables need, on any machine.
#pragma once

#include <filesystem>
#include <vector>

#include "results/scaling.h"
#include "results/tables/tables.h"

namespace raysweep {

struct RunData {
  TableContext context;  // with the noise floor of its twins
  std::vector<CellRow> rows;
  std::vector<Record> records;
};

/// Reads plan.json and records.jsonl of `folder`. Throws RecordError where they are missing or not readable.
[[nodiscard]] RunData read_run(const std::filesystem::path& folder);

}  // namespace raysweep
