#include "experiments/overhead/row.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>

#include "experiments/errors.h"
#include "experiments/overhead/busy_work.h"
#include "experiments/overhead/idle_burn.h"
#include "experiments/overhead/task_sweep.h"
#include "schedulers/registry.h"

namespace raysweep {

namespace {

/// Enough for a 95 % interval of the median that leaves out the extremes (9 or more, see
/// median_interval_rank).
constexpr int repetitions = 9;

/// A row's time: shorter measurements need less of it. Google Benchmark takes up to twice its share, to find
/// out how often to run.
constexpr double region_share = 0.1, chunks_share = 0.15, sizes_share = 0.5;

/// The idle burn is a few sleeps each.
constexpr int burn_samples = 5;

const char* const region_name = "empty_region";
const char* const chunks_name = "chunks_of_nothing";

/// Chunks of a run, about: 10⁵ of the cheapest, some 10 ns each, take a hundred times as long as waking the
/// workers. Where each is a task that exists until it ran, 10⁴: they cost ten times as much, and memory.
size_t many_chunks(std::string_view scheduler) {
  return scheduler == "omp_taskloop" || scheduler == "tbb_task_group" ? 10'000 : 100'000;
}

/// Keeps the time of each repetition, and prints nothing: standard output is for the samples.
class Collector final : public benchmark::BenchmarkReporter {
 public:
  explicit Collector(RowSamples& samples) : samples_(samples) {}
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;
      const bool region = run.run_name.function_name == region_name;
      const double seconds = run.GetAdjustedRealTime() * 1e-9;  // the unit is set to nanoseconds below
      (region ? samples_.region_seconds : samples_.chunks_seconds).push_back(seconds);
      if (!region) samples_.chunks = run.counters.at("chunks").value;
    }
  }

 private:
  RowSamples& samples_;
};

/// Runs of `items` items of nothing, in chunks of one.
void run_nothing(benchmark::State& state, Scheduler& scheduler, size_t items, int threads) {
  const Body nothing = [](size_t, size_t, int) {};
  WorkerLog log(threads);
  const Chunk chunk = one_item_chunks(items, threads);
  for ([[maybe_unused]] auto _ : state) scheduler.run({items}, chunk, nothing, log);
  state.counters["chunks"] = static_cast<double>(log.chunks()) / static_cast<double>(state.iterations());
}

class Benchmarks {
 public:
  Benchmarks(Scheduler& scheduler, int threads, const std::vector<std::string>& flags)
      : scheduler_(scheduler), threads_(threads), flags_(flags) {}

  void add(const char* name, size_t items, double seconds) const {
    auto* const one = benchmark::RegisterBenchmark(
        name, [this, items](benchmark::State& state) { run_nothing(state, scheduler_, items, threads_); });
    one->UseRealTime()->Unit(benchmark::kNanosecond);
    if (!flagged("--benchmark_repetitions")) one->Repetitions(repetitions);
    if (!flagged("--benchmark_min_time")) one->MinTime(seconds / repetitions);
  }

  void run(RowSamples& samples) const {
    std::vector<std::string> flags = flags_;
    flags.insert(flags.begin(), "overhead_lab");
    std::vector<char*> raw;
    for (std::string& flag : flags) raw.push_back(flag.data());
    int count = static_cast<int>(raw.size());
    raw.push_back(nullptr);
    benchmark::Initialize(&count, raw.data());
    if (count > 1)
      throw RequestError(fmt::format("\"{}\" is no flag of Google Benchmark's; see its user guide", raw[1]));
    Collector collector(samples);
    benchmark::RunSpecifiedBenchmarks(&collector);
  }

 private:
  [[nodiscard]] bool flagged(std::string_view name) const {
    return std::ranges::any_of(flags_, [name](const std::string& flag) { return flag.starts_with(name); });
  }

  Scheduler& scheduler_;
  int threads_;
  const std::vector<std::string>& flags_;
};

void measure_burn(Scheduler& scheduler, int threads, RowSamples& samples) {
  const Body nothing = [](size_t, size_t, int) {};
  const auto items = static_cast<size_t>(threads);
  WorkerLog log(threads);
  for (int i = 0; i < burn_samples; ++i) {
    scheduler.run({items}, one_item_chunks(items, threads), nothing, log);
    const IdleBurn burn = watch_idle();
    samples.burns.push_back({burn.cpu_seconds, burn.went_quiet});
  }
}

/// Throws RequestError for a runtime that the scheduler does not have.
void check_runtime(const Subject& subject, const SchedulerInfo& info) {
  if (subject.runtime.empty()) return;
  std::vector<std::string_view> possible;
  for (const RuntimeInfo& runtime : all_runtimes()) {
    if (info.uses_runtime() && runtime.family == info.family) possible.push_back(runtime.name);
  }
  if (std::ranges::find(possible, subject.runtime) == possible.end())
    throw RequestError(
        fmt::format("--runtime: {} cannot run on \"{}\"; possible: {}", subject.scheduler, subject.runtime,
                    possible.empty() ? "none to choose" : fmt::format("{}", fmt::join(possible, ", "))));
}

}  // namespace

RowSamples measure_row(const RowRequest& request, const std::vector<std::string>& benchmark_flags) {
  const auto& [subject, parts, seconds, useful_at_once, given] = request;
  const SchedulerInfo* const info = find_scheduler(subject.scheduler);
  if (!info) throw RequestError(fmt::format("--scheduler: unknown scheduler \"{}\"", subject.scheduler));
  check_runtime(subject, *info);
  // Before there are workers, who might still be awake.
  const WorkSpeed speed = given.iteration > 0 || !parts.sizes ? given : measure_work_speed();
  const auto scheduler = make_scheduler(subject.scheduler, subject.options());
  const int threads = subject.threads;
  const auto per_thread = static_cast<size_t>(threads);
  WorkerLog log(threads);
  for (int run = 0; run < info->warmup_runs; ++run)
    scheduler->run(
        {per_thread}, one_item_chunks(per_thread, threads), [](size_t, size_t, int) {}, log);

  RowSamples samples;
  const Benchmarks benchmarks(*scheduler, threads, benchmark_flags);
  if (parts.region) benchmarks.add(region_name, per_thread, seconds * region_share);
  if (parts.chunks && info->uses_chunk) {
    const size_t each = std::max<size_t>(1, many_chunks(subject.scheduler) / per_thread);
    benchmarks.add(chunks_name, each * per_thread, seconds * chunks_share);
  }
  if (parts.region || parts.chunks) benchmarks.run(samples);
  if (parts.sizes)
    sweep_task_sizes(*scheduler, threads, {seconds * sizes_share, speed, useful_at_once}, samples);
  if (parts.burn) measure_burn(*scheduler, threads, samples);
  return samples;
}

}  // namespace raysweep
