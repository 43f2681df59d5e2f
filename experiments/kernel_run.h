// Runs kernel experiments: from a plan to records in a folder.
#pragma once

#include <memory>
#include <string>

#include "experiments/kernel_plan.h"
#include "experiments/run_files.h"

namespace raysweep {

/// A kernel experiment that can be run: everything that can be refused has been.
struct KernelExperiment {
  KernelPlan plan;
  std::unique_ptr<RunFiles> files;
};

/// Makes its folder, or takes it up. Throws RequestError as RunFiles, and where nothing can be timed.
[[nodiscard]] KernelExperiment open_kernels(const KernelConfig& config, const std::filesystem::path& folder,
                                            const Machine& machine, bool resume);

enum class KernelEnd { complete, out_of_budget, interrupted, failed };

struct KernelReport {
  KernelEnd end = KernelEnd::complete;
  size_t records = 0;       // that there are now, with those of an earlier run
  size_t void_records = 0;  // of those made now: results were wrong
  std::string first_void, failure;
};

/// Runs what the folder lacks: in each round all cells, in an order from the seed, one record each, which is
/// written at once. Results are compared before anything is timed: hits with those that are certain, and with
/// the base kernel's of the method; by as many as tests are unclear they may differ. `quiet` keeps progress
/// to itself. Ends early when the program is interrupted or the budget is used up.
[[nodiscard]] KernelReport run_kernels(const KernelExperiment& experiment, bool quiet);

/// What `--dry-run` tells: every cell, what is left out, and how often each is timed.
[[nodiscard]] std::string plan_as_text(const KernelPlan& plan);

/// Seconds for all rounds, from the length of samples.
[[nodiscard]] double estimate_seconds(const KernelPlan& plan);

}  // namespace raysweep
