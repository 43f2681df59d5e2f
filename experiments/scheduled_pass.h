// A pass of several parts, which a scheduler shares among its threads.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/kernel_timer.h"
#include "schedulers/scheduler.h"

namespace raysweep {

/// Parts for each thread: so many that a scheduler has something to hand out, so few that each is many tests.
constexpr int parts_a_thread = 4;

/// Schedulers that passes of kernels may be given to, where they are available. None on OpenMP: all cells
/// share one process, and its threads spin on for a while when their work is done, into the time of whatever
/// comes next.
[[nodiscard]] std::vector<std::string_view> kernel_schedulers();

class ScheduledPass {
 public:
  /// Makes the threads. Throws SchedulerError as `make_scheduler`. To be run by the thread that makes it.
  ScheduledPass(const std::string& scheduler, int threads, std::vector<TimedPass> parts);

  /// Runs each part once. The sum of what they tell.
  [[nodiscard]] double run();

 private:
  /// What a part found, in cache lines of its own: two, since processors fetch them in pairs.
  struct alignas(128) Found {
    double value = 0;
  };

  std::vector<TimedPass> parts_;
  std::vector<Found> found_;
  WorkerLog log_;
  Body body_;
  std::unique_ptr<Scheduler> scheduler_;
};

}  // namespace raysweep
