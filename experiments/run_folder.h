// The folder of a run: who may write into it, and how nothing in it is ever lost or half there.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/config.h"
#include "experiments/file_descriptor.h"
#include "experiments/machine/machine.h"
#include "experiments/plan.h"
#include "results/record.h"

namespace raysweep {

class RunFolder {
 public:
  /// Makes `path` and locks it until this object is gone or the process has died, however. Writes
  /// config.toml, plan.json and machine.json. With `resume` an earlier run of the same config and seed is
  /// taken up; without it the folder must hold none. Throws RequestError: not writable, in use, holds a run,
  /// holds another run.
  RunFolder(std::filesystem::path path, const Config& config, const Plan& plan, const Machine& machine,
            bool resume);
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] const std::vector<Record>& records() const { return records_; }

  /// Writes one line to records.jsonl and waits until it is on disk. A line that does not fit is taken back
  /// whole and throws WorkError.
  void append(const Record& record);

 private:
  void lock();
  void take_up(const Config& config, const Plan& plan, const Machine& machine, bool resume);

  std::filesystem::path path_;
  std::vector<Record> records_;
  FileDescriptor lock_, file_;
};

}  // namespace raysweep
