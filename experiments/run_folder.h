// The folder of a run of pictures.
#pragma once

#include <filesystem>
#include <vector>

#include "experiments/config.h"
#include "experiments/plan.h"
#include "experiments/run_files.h"
#include "results/record.h"

namespace raysweep {

class RunFolder {
 public:
  /// As RunFiles. Throws RequestError, too, for records that cannot be read.
  RunFolder(std::filesystem::path path, const Config& config, const Plan& plan, const Machine& machine,
            bool resume);

  [[nodiscard]] const std::filesystem::path& path() const { return files_.path(); }
  [[nodiscard]] const std::vector<Record>& records() const { return records_; }

  /// Writes one line to records.jsonl and waits until it is on disk. A line that does not fit is taken back
  /// whole and throws WorkError.
  void append(const Record& record);

 private:
  RunFiles files_;
  std::vector<Record> records_;
};

}  // namespace raysweep
