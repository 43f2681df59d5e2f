#include "schedulers/registry.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <map>
#include <mutex>
#include <system_error>

#include "schedulers/builtin.h"
#include "schedulers/module.h"

namespace raysweep {

namespace {

using Make = std::unique_ptr<Scheduler> (*)(int threads);

struct Entry {
  SchedulerInfo info;
  Make make;  // null: asked from the family's module
};

constexpr std::array entries{
    Entry{{"serial", "std", "no threads at all: the base of every speedup", false}, make_serial},
    Entry{{"thread_static", "std", "std::thread, one contiguous block per thread"}, make_thread_static},
    Entry{{"thread_cyclic", "std", "std::thread, chunks dealt round robin", true, true}, make_thread_cyclic},
    Entry{{"thread_dynamic", "std", "std::thread, next chunk from a shared counter", true, true},
          make_thread_dynamic},
    Entry{{"thread_chunks", "std", "std::thread, threads x chunk equal parts in a queue (Morozov 2011)", true,
           true},
          make_thread_chunks},
    Entry{{"thread_spawn", "std", "std::thread, created anew for every frame, one block each"},
          make_thread_spawn},
    Entry{{"omp_static", "openmp", "OpenMP, schedule(static): one contiguous block per thread"}, nullptr},
    Entry{{"omp_dynamic", "openmp", "OpenMP, schedule(dynamic, chunk)", true, true}, nullptr},
    Entry{{"omp_guided", "openmp", "OpenMP, schedule(guided, chunk): shrinking chunks", true, true}, nullptr},
    Entry{{"tbb_auto", "tbb", "TBB parallel_for, auto_partitioner, chunk = grain", true, true}, nullptr},
    Entry{{"tbb_simple", "tbb", "TBB parallel_for, simple_partitioner, chunk = grain", true, true}, nullptr},
    Entry{{"tbb_static", "tbb", "TBB parallel_for, static_partitioner, chunk = grain", true, true}, nullptr},
    // It remembers from run to run who had what: three runs settle it.
    Entry{{"tbb_affinity", "tbb", "TBB parallel_for, affinity_partitioner kept across frames, chunk = grain",
           true, true, 3},
          nullptr},
};

constexpr std::array<SchedulerInfo, entries.size()> infos = [] {
  std::array<SchedulerInfo, entries.size()> list{};
  for (size_t i = 0; i < entries.size(); ++i) list[i] = entries[i].info;
  return list;
}();

constexpr std::array<std::string_view, 2> families{"openmp", "tbb"};

struct LoadedModule {
  const Module* module = nullptr;
  std::string problem;
};

LoadedModule load_module(std::string_view family) {
  const auto folder = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "modules";
  const std::string file = (folder / fmt::format("raysweep_{}.so", family)).string();
  if (!std::filesystem::exists(file)) {
    return {nullptr,
            fmt::format("not built: {} was not found when raysweep was configured",
                        family == "tbb" ? "TBB (libtbb-dev)" : "OpenMP (a compiler's libgomp or libomp)")};
  }
  void* const library =
      dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);  // stays loaded: runtimes keep threads of their own
  if (!library) return {nullptr, fmt::format("cannot be loaded: {}", dlerror())};
  const auto function = reinterpret_cast<ModuleFunction>(dlsym(library, module_symbol));
  if (!function) return {nullptr, fmt::format("{} is no raysweep module", file)};
  return {function(), {}};
}

const LoadedModule& module_of(std::string_view family) {
  static std::mutex mutex;
  static std::map<std::string_view, LoadedModule> loaded;
  const std::scoped_lock lock(mutex);
  const auto known = loaded.find(family);
  return known != loaded.end() ? known->second : loaded.emplace(family, load_module(family)).first->second;
}

bool is_module(std::string_view family) { return std::ranges::find(families, family) != families.end(); }

Make find_make(const Entry& entry) {
  if (entry.make) return entry.make;
  const LoadedModule& loaded = module_of(entry.info.family);
  if (!loaded.module)
    throw SchedulerError(fmt::format("scheduler \"{}\" is {}", entry.info.name, loaded.problem));
  for (const ModuleEntry& offered : loaded.module->schedulers) {
    if (offered.name == entry.info.name) return offered.make;
  }
  throw SchedulerError(fmt::format("scheduler \"{}\" is missing from its module", entry.info.name));
}

}  // namespace

std::span<const SchedulerInfo> all_schedulers() { return infos; }

const SchedulerInfo* find_scheduler(std::string_view name) {
  const auto found = std::ranges::find(infos, name, &SchedulerInfo::name);
  return found == infos.end() ? nullptr : &*found;
}

std::span<const std::string_view> module_families() { return families; }

std::string why_unavailable(std::string_view family) {
  return is_module(family) ? module_of(family).problem : std::string();
}

std::string runtime_of(std::string_view family) {
  const Module* const module = is_module(family) ? module_of(family).module : nullptr;
  return module ? module->runtime : std::string();
}

std::unique_ptr<Scheduler> make_scheduler(std::string_view name, int threads) {
  const auto entry = std::ranges::find(entries, name, [](const Entry& e) { return e.info.name; });
  if (entry == entries.end()) throw SchedulerError(fmt::format("unknown scheduler \"{}\"", name));
  if (threads < min_threads || threads > max_threads) {
    throw SchedulerError(
        fmt::format("threads = {} is out of range: {} to {}", threads, min_threads, max_threads));
  }
  try {
    auto scheduler = find_make(*entry)(threads);
    WorkerLog log(threads);
    scheduler->run(
        {static_cast<size_t>(threads)}, {}, [](size_t, size_t, int) {}, log);  // runtimes make threads late
    return scheduler;
  } catch (const std::system_error& error) {
    throw SchedulerError(fmt::format("{} threads cannot be made: {}", threads, error.what()));
  }
}

}  // namespace raysweep
