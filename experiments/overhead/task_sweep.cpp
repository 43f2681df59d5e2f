#include "experiments/overhead/task_sweep.h"

#include "experiments/clock.h"
#include "experiments/interrupt.h"
#include "results/statistics/statistics.h"

namespace raysweep {

namespace {

/// Waking all workers costs some 10 µs: over a thousand tasks that is 10 ns each, less than handing one out.
constexpr int tasks_per_thread = 1000;

/// One iteration is hardly more than the call: no more than a chunk costs with the cheapest scheduler. 2³⁰ of
/// them are more than a second.
constexpr double least_iterations = 1, most_iterations = 1 << 30;

/// Of a size; the median of them is kept. Before them comes one that is not timed.
constexpr int timed_runs = 5;

/// The sweep ends when so many sizes on end have been this efficient: one could be luck.
constexpr int good_sizes_on_end = 3;
constexpr double good_efficiency = 0.95;

double median_seconds(Scheduler& scheduler, int threads, double iterations) {
  const size_t tasks = static_cast<size_t>(threads) * tasks_per_thread;
  const Body body = busy_items(static_cast<std::uint64_t>(iterations));
  WorkerLog log(threads);
  std::vector<double> seconds;
  for (int run = -1; run < timed_runs; ++run) {
    const double begin = now_seconds();
    scheduler.run({tasks}, one_item_chunks(tasks, threads), body, log);
    if (run >= 0) seconds.push_back(now_seconds() - begin);
  }
  return median(seconds);
}

}  // namespace

double efficiency(double tasks, double task_ns, double useful_at_once, double seconds) {
  return tasks * task_ns * 1e-9 / useful_at_once / seconds;
}

void sweep_task_sizes(Scheduler& scheduler, int threads, const SweepLimits& limits, RowSamples& samples) {
  samples.tasks = static_cast<double>(threads) * tasks_per_thread;
  const double end = now_seconds() + limits.seconds;
  int good = 0;
  for (double iterations = least_iterations; iterations <= most_iterations; iterations *= 2) {
    // Twice the last size's run is what this one needs at most.
    const double needed = samples.sizes.empty() ? 0 : 2 * samples.sizes.back().seconds * (timed_runs + 1);
    if (good == good_sizes_on_end || now_seconds() + needed > end || interrupted()) return;
    const double seconds = median_seconds(scheduler, threads, iterations);
    samples.sizes.push_back({iterations, seconds});
    const double reached =
        efficiency(samples.tasks, limits.speed.nanoseconds(iterations), limits.useful_at_once, seconds);
    good = reached >= good_efficiency ? good + 1 : 0;
  }
}

}  // namespace raysweep
