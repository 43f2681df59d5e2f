// The one list of schedulers.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "schedulers/binding.h"
#include "schedulers/modules.h"
#include "schedulers/options.h"
#include "schedulers/scheduler.h"

namespace raysweep {

struct SchedulerInfo {
  std::string_view name;
  std::string_view family;  // "std", or that of the runtimes which it may run on: "openmp", "tbb"
  std::string_view summary;
  bool uses_threads = true;  // false: always one
  bool uses_chunk = false;
  int warmup_runs = 1;  // until it has settled

  /// Whether it runs on one of several runtimes, to be chosen.
  [[nodiscard]] bool uses_runtime() const { return family == "openmp"; }
  /// Whether its workers can be told how to wait.
  [[nodiscard]] bool uses_wait_policy() const;
};

/// Whether spin counts mean something to the scheduler on this runtime.
[[nodiscard]] bool uses_spin_count(const SchedulerInfo& info, std::string_view runtime);

/// Every scheduler of this project, those that are not available here included.
[[nodiscard]] std::span<const SchedulerInfo> all_schedulers();

/// Null for an unknown name.
[[nodiscard]] const SchedulerInfo* find_scheduler(std::string_view name);

/// The runtime that a scheduler gets where none is chosen: the first of its family that is available here;
/// where none is, the first. Empty for those that need none.
[[nodiscard]] std::string default_runtime(const SchedulerInfo& info);

/// Why the scheduler cannot be made here on `runtime` (empty: its default), as a sentence's end: "is …";
/// empty if it can.
[[nodiscard]] std::string why_unavailable(const SchedulerInfo& info, const std::string& runtime = {});

/// A scheduler, warm: each of its workers is there, and where it was bound to. Throws SchedulerError:
/// unknown, unavailable, out of range, a processor that is not allowed, or the system has no more threads.
[[nodiscard]] std::unique_ptr<Scheduler> make_scheduler(std::string_view name,
                                                        const SchedulerOptions& options);

/// The processors that each worker is allowed, told from inside it, in the order of the workers; a worker
/// that got nothing to do, though all were waited for, has none.
[[nodiscard]] std::vector<ProcessorSet> processors_of_workers(Scheduler& scheduler, int threads);

}  // namespace raysweep
