// The one list of schedulers.
#pragma once

#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "schedulers/scheduler.h"

namespace raysweep {

/// Bounds of `threads`, both included. More threads than processors is oversubscription, and allowed.
inline constexpr int min_threads = 1, max_threads = 1024;

struct SchedulerInfo {
  std::string_view name;
  std::string_view family;  // of backends: "std", "openmp", "tbb"; the last two are modules
  std::string_view summary;
  bool uses_threads = true;  // false: always one
  bool uses_chunk = false;
  int warmup_runs = 1;  // until it has settled
};

/// Every scheduler of this project, those that are not available here included.
[[nodiscard]] std::span<const SchedulerInfo> all_schedulers();

/// Null for an unknown name.
[[nodiscard]] const SchedulerInfo* find_scheduler(std::string_view name);

/// Why schedulers of `family` cannot be made here, as a sentence; empty if they can. Loads the family's
/// module.
[[nodiscard]] std::string why_unavailable(std::string_view family);

/// The families that come as modules.
[[nodiscard]] std::span<const std::string_view> module_families();

/// The runtime library behind `family`, with its version and file: "libgomp (OpenMP 201511),
/// /lib/…/libgomp.so.1". Empty where it is unavailable.
[[nodiscard]] std::string runtime_of(std::string_view family);

/// A scheduler with `threads` workers, warm. Throws SchedulerError: unknown, unavailable, out of range, or
/// the system has no more threads.
[[nodiscard]] std::unique_ptr<Scheduler> make_scheduler(std::string_view name, int threads);

struct SchedulerError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace raysweep
