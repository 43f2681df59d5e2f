// Runs accuracy experiments: from a plan to records in a folder.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "experiments/accuracy_config.h"
#include "experiments/run_files.h"

namespace raysweep {

/// An accuracy experiment that can be run: everything that can be refused has been.
struct AccuracyExperiment {
  AccuracyPlan plan;
  std::unique_ptr<RunFiles> files;
};

/// Makes its folder, or takes it up. Throws RequestError as RunFiles.
[[nodiscard]] AccuracyExperiment open_accuracy(const AccuracyConfig& config,
                                               const std::filesystem::path& folder, const Machine& machine,
                                               bool resume);

struct AccuracyReport {
  size_t cells = 0;  // that there are records of now, with those of an earlier run
  bool was_interrupted = false;
  std::string failure;  // empty, or why records could not be written
};

/// Runs the cells that the folder lacks, on the plan's threads; `quiet` keeps progress to itself. Ends early
/// when the program is interrupted. Records are written in the plan's order, whenever one case at one
/// difficulty and all before it are through. Throws std::system_error if the system has no more threads.
[[nodiscard]] AccuracyReport run_accuracy(const AccuracyExperiment& experiment, bool quiet);

/// What `--dry-run` tells: every cell, what is left out, and how long all might take.
[[nodiscard]] std::string plan_as_text(const AccuracyPlan& plan);

/// Seconds for all cells on the plan's threads, from a run of some of them with few rays on as many.
[[nodiscard]] double estimate_seconds(const AccuracyPlan& plan);

}  // namespace raysweep
