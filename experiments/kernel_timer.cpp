#include "experiments/kernel_timer.h"

#include <benchmark/benchmark.h>

#include "experiments/machine/cycle_timer.h"

namespace raysweep {

namespace {

/// Keeps the time of each repetition, and prints nothing.
class Collector final : public benchmark::BenchmarkReporter {
 public:
  /// `real`: wall time, or what passes tell of themselves; else processor time.
  explicit Collector(bool real) : real_(real) {}
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;
      // Iterations are those of all threads; both times are a thread's mean.
      timing.iterations = static_cast<uint64_t>(run.iterations / run.threads);
      timing.seconds.push_back(real_ ? run.real_accumulated_time : run.cpu_accumulated_time);
    }
  }

  Timing timing;

 private:
  bool real_;
};

double seconds_after(const std::function<void()>& before, const TimedPass& pass) {
  before();
  CycleTimer timer;
  timer.begin();
  benchmark::DoNotOptimize(pass());
  timer.end();
  return tick_clock().seconds(timer.ticks(CycleTimer::Mode::sum));
}

}  // namespace

std::string why_no_kernel_timer() { return {}; }

// Cells are registered and run one by one: the order in which they alternate is the plan's, from its seed,
// which `--benchmark_enable_random_interleaving` could not be given, and each is on disk before the next.
Timing time_passes(const std::vector<TimedPass>& passes, const TimingRequest& request) {
  benchmark::ClearRegisteredBenchmarks();
  auto* const one = benchmark::RegisterBenchmark(request.name.c_str(), [&](benchmark::State& state) {
    const TimedPass& pass = passes[static_cast<size_t>(state.thread_index())];
    benchmark::DoNotOptimize(pass());
    if (request.before) {
      for ([[maybe_unused]] auto _ : state) state.SetIterationTime(seconds_after(request.before, pass));
    } else {
      for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(pass());
    }
  });
  one->Repetitions(request.samples)->Threads(static_cast<int>(passes.size()));
  if (passes.size() > 1) one->UseRealTime();
  if (request.before) one->UseManualTime();
  if (request.iterations > 0) {
    one->Iterations(static_cast<benchmark::IterationCount>(request.iterations));
  } else {
    one->MinTime(request.min_seconds);
  }
  Collector collector(request.before || passes.size() > 1);
  benchmark::RunSpecifiedBenchmarks(&collector);
  benchmark::ClearRegisteredBenchmarks();
  return collector.timing;
}

}  // namespace raysweep
