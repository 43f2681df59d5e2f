#include "schedulers/registry.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <system_error>
#include <thread>

#include "schedulers/builtin.h"

namespace raysweep {

namespace {

struct Entry {
  SchedulerInfo info;
  MakeScheduler make;  // null: asked from a module
};

constexpr std::array entries{
    Entry{{"serial", "std", "no threads at all: the base of every speedup", false}, make_serial},
    Entry{{"thread_static", "std", "std::thread, one contiguous block per thread"}, make_thread_static},
    Entry{{"thread_cyclic", "std", "std::thread, chunks dealt round robin", true, true}, make_thread_cyclic},
    Entry{{"thread_dynamic", "std", "std::thread, next chunk from a shared counter", true, true},
          make_thread_dynamic},
    Entry{{"thread_guided", "std", "std::thread, shrinking chunks from a shared counter, chunk = smallest",
           true, true},
          make_thread_guided},
    Entry{{"thread_chunks", "std", "std::thread, threads x chunk equal parts in a queue (Morozov 2011)", true,
           true},
          make_thread_chunks},
    Entry{{"thread_spawn", "std", "std::thread, created anew for every frame, one block each"},
          make_thread_spawn},
    Entry{
        {"thread_stealing", "std", "std::thread, a deque each, random victims, chunk = smallest", true, true},
        make_thread_stealing},
    Entry{{"omp_static", "openmp", "OpenMP, schedule(static): one contiguous block per thread"}, nullptr},
    Entry{{"omp_static_chunk", "openmp", "OpenMP, schedule(static, chunk): chunks dealt round robin", true,
           true},
          nullptr},
    Entry{{"omp_dynamic", "openmp", "OpenMP, schedule(dynamic, chunk)", true, true}, nullptr},
    Entry{{"omp_guided", "openmp", "OpenMP, schedule(guided, chunk): shrinking chunks", true, true}, nullptr},
    Entry{{"omp_auto", "openmp", "OpenMP, schedule(auto): the runtime's choice"}, nullptr},
    Entry{{"omp_taskloop", "openmp", "OpenMP, taskloop, a task for each chunk", true, true}, nullptr},
    Entry{{"tbb_auto", "tbb", "TBB parallel_for, auto_partitioner, chunk = grain", true, true}, nullptr},
    Entry{{"tbb_simple", "tbb", "TBB parallel_for, simple_partitioner, chunk = grain", true, true}, nullptr},
    Entry{{"tbb_static", "tbb", "TBB parallel_for, static_partitioner, chunk = grain", true, true}, nullptr},
    // It remembers from run to run who had what: three runs settle it.
    Entry{{"tbb_affinity", "tbb", "TBB parallel_for, affinity_partitioner kept across frames, chunk = grain",
           true, true, 3},
          nullptr},
    Entry{{"tbb_range2d", "tbb", "TBB parallel_for over a grid of tiles, simple_partitioner, chunk = grain",
           true, true},
          nullptr},
    Entry{{"tbb_task_group", "tbb", "TBB task_group, a task for each chunk", true, true}, nullptr},
    Entry{{"stdpar", "tbb", "std::for_each(std::execution::par): chunks are the library's choice"}, nullptr},
};

constexpr std::array<SchedulerInfo, entries.size()> infos = [] {
  std::array<SchedulerInfo, entries.size()> list{};
  for (size_t i = 0; i < entries.size(); ++i) list[i] = entries[i].info;
  return list;
}();

MakeScheduler find_make(const Entry& entry, const SchedulerOptions& options) {
  if (entry.make) return entry.make;
  const std::string runtime = options.runtime.empty() ? default_runtime(entry.info) : options.runtime;
  for (const ModuleEntry& offered : load_module(runtime, options).schedulers) {
    if (offered.name != entry.info.name) continue;
    if (!offered.make)
      throw SchedulerError(fmt::format("scheduler \"{}\" is {}", offered.name, offered.problem));
    return offered.make;
  }
  throw SchedulerError(fmt::format("scheduler \"{}\" is missing from its module", entry.info.name));
}

void check(std::string_view name, const SchedulerOptions& options) {
  if (options.threads < min_threads || options.threads > max_threads) {
    throw SchedulerError(
        fmt::format("threads = {} is out of range: {} to {}", options.threads, min_threads, max_threads));
  }
  const ProcessorSet allowed = allowed_processors();
  for (const int processor : options.processors) {
    if (std::ranges::binary_search(allowed, processor)) continue;
    throw SchedulerError(fmt::format("{} cannot be bound to processor {}: allowed here: {}", name, processor,
                                     fmt::join(allowed, ", ")));
  }
}

/// Each worker tells its processors, and waits until all others are there, so that none can do another's
/// part.
class Muster {
 public:
  explicit Muster(int threads) : told_(static_cast<size_t>(threads)) {}

  void tell(int worker) {
    ProcessorSet& mine = told_[static_cast<size_t>(worker)];
    if (!mine.empty()) return;
    mine = allowed_processors();
    there_.fetch_add(1);
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(2);
    while (there_.load() < told_.size() && std::chrono::steady_clock::now() < give_up)
      std::this_thread::yield();
  }
  [[nodiscard]] std::vector<ProcessorSet> told() && { return std::move(told_); }

 private:
  std::vector<ProcessorSet> told_;
  std::atomic<size_t> there_{0};
};

}  // namespace

bool SchedulerInfo::uses_wait_policy() const {
  return uses_threads && family != "tbb" && name != "thread_spawn";
}

bool uses_spin_count(const SchedulerInfo& info, std::string_view runtime) {
  return info.uses_wait_policy() && runtime != "libomp";  // which counts milliseconds: KMP_BLOCKTIME
}

std::span<const SchedulerInfo> all_schedulers() { return infos; }

const SchedulerInfo* find_scheduler(std::string_view name) {
  const auto found = std::ranges::find(infos, name, &SchedulerInfo::name);
  return found == infos.end() ? nullptr : &*found;
}

std::string default_runtime(const SchedulerInfo& info) {
  std::string first;
  for (const RuntimeInfo& runtime : all_runtimes()) {
    if (runtime.family != info.family) continue;
    if (module_report(std::string(runtime.name)).problem.empty()) return std::string(runtime.name);
    if (first.empty()) first = runtime.name;
  }
  return first;
}

std::string why_unavailable(const SchedulerInfo& info, const std::string& runtime) {
  const std::string name = runtime.empty() ? default_runtime(info) : runtime;
  if (name.empty()) return {};
  const ModuleReport& report = module_report(name);
  if (!report.problem.empty()) return report.problem;
  const auto own = report.problems.find(std::string(info.name));
  return own == report.problems.end() ? std::string() : own->second;
}

std::unique_ptr<Scheduler> make_scheduler(std::string_view name, const SchedulerOptions& options) {
  const auto entry = std::ranges::find(entries, name, [](const Entry& e) { return e.info.name; });
  if (entry == entries.end()) throw SchedulerError(fmt::format("unknown scheduler \"{}\"", name));
  check(name, options);
  try {
    auto scheduler = find_make(*entry, options)(options);
    // Runtimes make threads late, and no more than a short run needs: all are waited for.
    (void)processors_of_workers(*scheduler, entry->info.uses_threads ? options.threads : 1);
    return scheduler;
  } catch (const std::system_error& error) {
    throw SchedulerError(fmt::format("{} threads cannot be made: {}", options.threads, error.what()));
  }
}

std::vector<ProcessorSet> processors_of_workers(Scheduler& scheduler, int threads) {
  Muster muster(threads);
  WorkerLog log(threads);
  // Many items for each: splitting libraries may give a worker several at once.
  scheduler.run(
      {static_cast<size_t>(threads) * 16}, {}, [&](size_t, size_t, int worker) { muster.tell(worker); }, log);
  return std::move(muster).told();
}

}  // namespace raysweep
