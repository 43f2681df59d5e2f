#include "experiments/kernel_timer.h"

#include <benchmark/benchmark.h>

#include "experiments/intersection/kernel.h"

namespace raysweep {

namespace {

/// Keeps the time of each repetition, and prints nothing.
class Collector final : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;
      // Iterations are those of all threads; both times are a thread's mean.
      timing.iterations = static_cast<uint64_t>(run.iterations / run.threads);
      timing.seconds.push_back(run.threads > 1 ? run.real_accumulated_time : run.cpu_accumulated_time);
    }
  }

  Timing timing;
};

}  // namespace

std::string why_no_kernel_timer() { return {}; }

// Cells are registered and run one by one: the order in which they alternate is the plan's, from its seed,
// which `--benchmark_enable_random_interleaving` could not be given, and each is on disk before the next.
Timing time_passes(const std::vector<std::unique_ptr<KernelPass>>& passes, const TimingRequest& request) {
  benchmark::ClearRegisteredBenchmarks();
  auto* const one = benchmark::RegisterBenchmark(request.name.c_str(), [&](benchmark::State& state) {
    KernelPass& pass = *passes[static_cast<size_t>(state.thread_index())];
    benchmark::DoNotOptimize(pass.run());
    for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(pass.run());
  });
  one->Repetitions(request.samples)->Threads(static_cast<int>(passes.size()));
  if (passes.size() > 1) one->UseRealTime();
  if (request.iterations > 0) {
    one->Iterations(static_cast<benchmark::IterationCount>(request.iterations));
  } else {
    one->MinTime(request.min_seconds);
  }
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  benchmark::ClearRegisteredBenchmarks();
  return collector.timing;
}

}  // namespace raysweep
