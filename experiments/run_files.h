// The files of a run, of whatever kind: who may write them, and how nothing in them is ever lost or half
// there.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "experiments/file_descriptor.h"
#include "experiments/machine/machine.h"

namespace raysweep {

/// What makes a run the same run when it is taken up again.
struct RunPapers {
  std::string config;  // the text of config.toml, as run
  nlohmann::json plan;
};

class RunFiles {
 public:
  /// Makes `path` and locks it until this object is gone or the process has died, however. Writes
  /// config.toml, plan.json and machine.json. With `resume` an earlier run of the same papers is taken up;
  /// without it the folder must hold none. Throws RequestError: not writable, in use, holds a run, holds
  /// another run.
  RunFiles(std::filesystem::path path, const RunPapers& papers, const Machine& machine, bool resume);
  RunFiles(const RunFiles&) = delete;
  RunFiles& operator=(const RunFiles&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Whether there are records of an earlier run, which is gone on with: whole lines of `records_file`.
  [[nodiscard]] bool holds_records() const { return holds_records_; }
  [[nodiscard]] std::filesystem::path records_file() const { return path_ / "records.jsonl"; }

  /// Writes whole lines to records.jsonl and waits until they are on disk. Lines that do not fit are taken
  /// back whole and throw WorkError, which calls what was written before `unit`, in plural.
  void append_text(const std::string& lines, const char* unit);

 private:
  void lock();
  void take_up(const RunPapers& papers, const Machine& machine, bool resume);

  std::filesystem::path path_;
  bool holds_records_ = false;
  FileDescriptor lock_, file_;
};

}  // namespace raysweep
