// What the process of one row found out, raw: its parent makes sense of it.
#pragma once

#include <string>
#include <vector>

namespace raysweep {

/// A run whose tasks were so long.
struct SizeSample {
  double iterations;  // of busy work in each task
  double seconds;     // the run's time, median over several
};

struct BurnSample {
  double cpu_seconds;
  bool went_quiet;
};

/// Parts that were not asked for are empty.
struct RowSamples {
  std::vector<double> region_seconds{};  // an empty region, one a repetition
  std::vector<double> chunks_seconds{};  // a run of many chunks of nothing, one a repetition
  double chunks = 0;                     // handed out in each of those
  double tasks = 0;                      // in each run of `sizes`
  std::vector<SizeSample> sizes{};
  std::vector<BurnSample> burns{};
};

[[nodiscard]] std::string to_line(const RowSamples& samples);

/// Throws nlohmann::json::exception if `line` is none.
[[nodiscard]] RowSamples row_samples_from_line(const std::string& line);

}  // namespace raysweep
