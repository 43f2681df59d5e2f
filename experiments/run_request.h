// What `raysweep run` is asked for: files, what the command line changes in them, and where each experiment
// goes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiments/config.h"
#include "experiments/machine/machine.h"
#include "experiments/studies.h"

namespace raysweep {

struct RunOptions {
  std::vector<std::string> files;      // experiments, or lists that include some
  std::vector<std::string> overrides;  // KEY=VALUE, for each experiment
  std::string out;
  std::optional<double> budget_minutes;  // of each experiment; of a list, for all that it includes
  std::optional<uint64_t> seed;
  bool resume = false, dry_run = false;
  bool quick = false;  // what the [quick] of each experiment changes, before `overrides`
};

/// Experiments that run together.
struct RunRequest {
  std::vector<Config> pictures;
  std::vector<std::unique_ptr<Study>> studies;
  std::map<std::string, std::filesystem::path> folders;  // by experiment
};

/// Reads all files and those that they include. Throws RequestError with one line per error of all of them.
[[nodiscard]] RunRequest read_request(const RunOptions& options, const Machine& machine);

}  // namespace raysweep
