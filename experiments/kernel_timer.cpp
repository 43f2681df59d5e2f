#include "experiments/kernel_timer.h"

#include <benchmark/benchmark.h>

#include <algorithm>

#include "experiments/clock.h"
#include "experiments/machine/cycle_timer.h"

namespace raysweep {

namespace {

/// Keeps the time of each repetition, and prints nothing.
class Collector final : public benchmark::BenchmarkReporter {
 public:
  /// `real`: wall time; else processor time.
  explicit Collector(bool real) : real_(real) {}
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;
      // Iterations are those of all threads.
      timing.iterations = static_cast<uint64_t>(run.iterations / run.threads);
      timing.seconds.push_back(real_ ? run.real_accumulated_time : run.cpu_accumulated_time);
    }
  }

  Timing timing;

 private:
  bool real_;
};

/// When each thread began and ended its passes, run by run. A thread writes to its own list alone.
class ThreadSpans {
 public:
  explicit ThreadSpans(size_t threads) : lists_(threads) {}

  void add(size_t thread, double begin, double end) { lists_[thread].push_back({begin, end}); }

  /// Of the last `samples` runs: from the first thread's begin to the last one's end. Google Benchmark has
  /// the mean of the threads' times, which is less where they take turns on fewer processors.
  [[nodiscard]] std::vector<double> seconds(size_t samples) const {
    std::vector<double> list;
    const size_t runs = lists_.front().size();
    for (size_t run = runs - std::min(runs, samples); run < runs; ++run) {
      Span all = lists_.front()[run];
      for (const std::vector<Span>& spans : lists_)
        all = {std::min(all.begin, spans[run].begin), std::max(all.end, spans[run].end)};
      list.push_back(all.end - all.begin);
    }
    return list;
  }

 private:
  struct Span {
    double begin, end;
  };
  std::vector<std::vector<Span>> lists_;
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
  ThreadSpans spans(passes.size());
  benchmark::ClearRegisteredBenchmarks();
  auto* const one = benchmark::RegisterBenchmark(request.name.c_str(), [&](benchmark::State& state) {
    const auto thread = static_cast<size_t>(state.thread_index());
    const TimedPass& pass = passes[thread];
    benchmark::DoNotOptimize(pass());
    double begin = 0;
    if (request.before) {
      for ([[maybe_unused]] auto _ : state) state.SetIterationTime(seconds_after(request.before, pass));
    } else {
      auto turn = state.begin();
      const auto last = state.end();  // here all threads wait for each other, and time begins
      begin = now_seconds();
      for (; turn != last; ++turn) benchmark::DoNotOptimize(pass());
    }
    spans.add(thread, begin, now_seconds());
  });
  one->Repetitions(request.samples)->Threads(static_cast<int>(passes.size()));
  const bool wall = request.wall_clock || request.before || passes.size() > 1;
  if (request.before)
    one->UseManualTime();
  else if (wall)
    one->UseRealTime();
  if (request.iterations > 0) {
    one->Iterations(static_cast<benchmark::IterationCount>(request.iterations));
  } else {
    one->MinTime(request.min_seconds);
  }
  Collector collector(wall);
  benchmark::RunSpecifiedBenchmarks(&collector);
  benchmark::ClearRegisteredBenchmarks();
  if (passes.size() > 1) collector.timing.seconds = spans.seconds(collector.timing.seconds.size());
  collector.timing.clock = wall ? "wall" : "processor";
  return collector.timing;
}

}  // namespace raysweep
