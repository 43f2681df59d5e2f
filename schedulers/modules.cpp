#include "schedulers/modules.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <link.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <sstream>

namespace raysweep {

namespace {

constexpr std::array runtimes{
    RuntimeInfo{"libgomp", "openmp", "g++ with its OpenMP runtime"},
    RuntimeInfo{"libomp", "openmp", "clang++ with LLVM's OpenMP runtime (clang, libomp-dev)"},
    RuntimeInfo{"tbb", "tbb", "TBB (libtbb-dev)"},
};

const RuntimeInfo& info_of(const std::string& runtime) {
  return *std::ranges::find(runtimes, runtime, &RuntimeInfo::name);
}

std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

/// Names of the OpenMP runtimes that are in this process, by the dynamic linker's list.
std::vector<std::string> openmp_runtimes_here() {
  std::vector<std::string> found;
  const auto look = [](dl_phdr_info* object, size_t, void* data) {
    const std::string name = file_name(object->dlpi_name);
    for (const std::string_view runtime : {"libgomp.so", "libomp.so", "libiomp5.so"}) {
      if (name.starts_with(runtime)) static_cast<std::vector<std::string>*>(data)->push_back(name);
    }
    return 0;
  };
  dl_iterate_phdr(look, &found);
  return found;
}

/// Whether an OpenMP runtime is in this process already: it has read its environment then.
bool is_here(const RuntimeInfo& info) {
  const std::vector<std::string> here = openmp_runtimes_here();
  return std::ranges::any_of(
      here, [&](const std::string& there) { return there.starts_with(fmt::format("{}.so", info.name)); });
}

struct Opened {
  const Module* module = nullptr;
  std::string problem;
};

/// Two OpenMP runtimes in one process would spin against each other, and answer each other's calls.
std::string conflict(const RuntimeInfo& info) {
  if (info.family != "openmp") return {};
  for (const std::string& there : openmp_runtimes_here()) {
    if (!there.starts_with(fmt::format("{}.so", info.name)))
      return fmt::format(
          "not usable in this process: it holds {} already, and two OpenMP runtimes disturb each "
          "other (is LD_PRELOAD set?)",
          there);
  }
  return {};
}

Opened open_module(const RuntimeInfo& info) {
  const auto folder = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "modules";
  const std::string file = (folder / fmt::format("raysweep_{}.so", info.name)).string();
  if (!std::filesystem::exists(file)) {
    return {nullptr, fmt::format("not built: {} was not found when raysweep was configured; there is no {}",
                                 info.needs, file)};
  }
  if (std::string problem = conflict(info); !problem.empty()) return {nullptr, std::move(problem)};
  void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) return {nullptr, fmt::format("not loadable: {}", dlerror())};
  const auto function = reinterpret_cast<ModuleFunction>(dlsym(library, module_symbol));
  if (!function) return {nullptr, fmt::format("not loadable: {} is no raysweep module", file)};
  const Module* const module = function();
  if (module->layout != shared_layout)
    return {nullptr,
            fmt::format("not usable: {} is of another build than this program; build all targets", file)};
  if (info.family == "openmp" &&
      !file_name(module->library.file).starts_with(fmt::format("{}.so", info.name)))
    return {nullptr,
            fmt::format("not what runs: its calls go to {} (is LD_PRELOAD set?)", module->library.file)};
  return {module, {}};
}

ModuleReport report_of(const Opened& opened) {
  ModuleReport report;
  report.problem = opened.problem;
  if (!opened.module) return report;
  report.version = opened.module->version;
  report.library = opened.module->library;
  for (const ModuleEntry& entry : opened.module->schedulers) {
    if (!entry.make) report.problems.emplace(entry.name, entry.problem);
  }
  return report;
}

ModuleReport problem(const std::string& text) { return {text, {}, {}, {}}; }

/// One line a field, and two for each scheduler with a problem.
std::string to_lines(const ModuleReport& report) {
  std::string text = fmt::format("{}\n{}\n{}\n{}\n", report.problem, report.version, report.library.file,
                                 report.library.build_id);
  for (const auto& [name, problem] : report.problems) text += fmt::format("{}\n{}\n", name, problem);
  return text;
}

ModuleReport from_lines(const std::string& text) {
  std::istringstream in(text);
  ModuleReport report;
  for (std::string* field :
       {&report.problem, &report.version, &report.library.file, &report.library.build_id})
    std::getline(in, *field);
  for (std::string name, problem; std::getline(in, name) && std::getline(in, problem);)
    report.problems.emplace(name, problem);
  return report;
}

/// Everything that can be read until the other side ends.
std::string read_all(int descriptor) {
  std::string text;
  std::array<char, 4096> buffer{};
  for (ssize_t n; (n = read(descriptor, buffer.data(), buffer.size())) > 0;) text.append(buffer.data(), n);
  return text;
}

/// In the child: tries the module, writes what it says of itself, and ends.
[[noreturn]] void answer_and_end(const RuntimeInfo& info, int out) {
  try {
    const std::string text = to_lines(report_of(open_module(info)));
    for (size_t at = 0; at < text.size();) {
      const ssize_t n = write(out, text.data() + at, text.size() - at);
      if (n <= 0) break;
      at += static_cast<size_t>(n);
    }
    _exit(0);
  } catch (...) {
    _exit(1);  // whatever it is, it must not go on as the parent's program
  }
}

ModuleReport ask_in_a_child(const RuntimeInfo& info) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return problem("not known: there is no pipe to ask its module through");
  const pid_t child = fork();
  if (child == 0) answer_and_end(info, ends[1]);
  close(ends[1]);
  const std::string text = child > 0 ? read_all(ends[0]) : std::string();
  close(ends[0]);
  int status = 0;
  while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  if (child < 0) return problem("not known: there is no process to try its module in");
  if (text.empty()) {
    return problem(
        WIFSIGNALED(status)
            ? fmt::format("not loadable: the process that tried it ended by signal {}", WTERMSIG(status))
            : fmt::format("not loadable: the process that tried it ended with code {}", WEXITSTATUS(status)));
  }
  return from_lines(text);
}

/// How workers wait, for the runtimes that read it from the environment when they are loaded.
void tell_how_to_wait(const std::string& runtime, const SchedulerOptions& options) {
  if (options.wait == WaitPolicy::active) setenv("OMP_WAIT_POLICY", "active", 1);
  if (options.wait == WaitPolicy::passive) setenv("OMP_WAIT_POLICY", "passive", 1);
  if (options.spin_count && runtime == "libgomp")
    setenv("GOMP_SPINCOUNT", std::to_string(*options.spin_count).c_str(), 1);
}

struct Loaded {
  Opened opened;
  WaitPolicy wait;
  std::optional<int> spin_count;
};

std::map<std::string, Loaded>& loaded_modules() {
  static std::map<std::string, Loaded> loaded;
  return loaded;
}

std::mutex& modules_mutex() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace

std::span<const RuntimeInfo> all_runtimes() { return runtimes; }

const ModuleReport& module_report(const std::string& runtime) {
  static std::map<std::string, ModuleReport> reports;
  const std::scoped_lock lock(modules_mutex());
  const auto known = reports.find(runtime);
  return known != reports.end() ? known->second
                                : reports.emplace(runtime, ask_in_a_child(info_of(runtime))).first->second;
}

const Module& load_module(const std::string& runtime, const SchedulerOptions& options) {
  const std::scoped_lock lock(modules_mutex());
  auto known = loaded_modules().find(runtime);
  if (known == loaded_modules().end()) {
    const bool told = options.wait != WaitPolicy::usual || options.spin_count;
    if (told && is_here(info_of(runtime)))
      throw SchedulerError(
          fmt::format("{} was loaded before it could be told how to wait (is LD_PRELOAD set?)", runtime));
    tell_how_to_wait(runtime, options);
    known = loaded_modules()
                .emplace(runtime, Loaded{open_module(info_of(runtime)), options.wait, options.spin_count})
                .first;
  }
  const Loaded& loaded = known->second;
  if (!loaded.opened.module) throw SchedulerError(fmt::format("{} is {}", runtime, loaded.opened.problem));
  const bool same = loaded.wait == options.wait && loaded.spin_count == options.spin_count;
  if (!same && info_of(runtime).family == "openmp")
    throw SchedulerError(
        fmt::format("{} is loaded in this process with another wait policy or spin count", runtime));
  return *loaded.opened.module;
}

}  // namespace raysweep
