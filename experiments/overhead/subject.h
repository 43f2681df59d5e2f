// What is measured in one process: a scheduler on a runtime with so many threads, and how they wait.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "schedulers/options.h"

namespace raysweep {

struct Subject {
  std::string scheduler;
  std::string runtime{};  // empty where there is no choice
  int threads = 1;
  WaitPolicy wait = WaitPolicy::usual;
  std::optional<int> spin_count{};
  bool beside_load = false;  // one busy process shares the processors

  [[nodiscard]] SchedulerOptions options() const;
  /// "omp_dynamic, libgomp, 2 threads, passive".
  [[nodiscard]] std::string text() const;
  /// "default", "passive", "spin 10000".
  [[nodiscard]] std::string wait_text() const;
};

/// Numbers, "cores" and "processors", by commas, as "1,cores,4": ascending, each once. Throws RequestError
/// for anything else.
[[nodiscard]] std::vector<int> parse_threads(const std::string& list, int cores, int processors);

/// Throws RequestError for a name that is none.
[[nodiscard]] WaitPolicy parse_wait_policy(const std::string& name);

/// Each of the schedulers named (none: all that are available), on each OpenMP runtime that is available,
/// with each count of threads; those that use no threads or cannot be told how to wait once. Throws
/// RequestError for one that is unknown or unavailable.
[[nodiscard]] std::vector<Subject> scheduler_subjects(std::span<const std::string> names,
                                                      std::span<const int> threads, WaitPolicy wait);

/// One static scheduler on each runtime whose workers can be told how to wait, in each way to wait: the team
/// is woken, and nothing is shared out. A single thread waits for nobody and is left out.
[[nodiscard]] std::vector<Subject> waiting_subjects(std::span<const int> threads, bool beside_load);

}  // namespace raysweep
