// The runtimes behind the schedulers, and the modules that bring them.
#pragma once

#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "schedulers/module.h"

namespace raysweep {

/// A library that runs a family of schedulers.
struct RuntimeInfo {
  std::string_view name;    // "libgomp"; also of the module: raysweep_libgomp.so
  std::string_view family;  // "openmp"
  std::string_view needs;   // to be built
};

/// All that this project has modules for, those that are not available here included.
[[nodiscard]] std::span<const RuntimeInfo> all_runtimes();

/// What a module says of itself.
struct ModuleReport {
  std::string problem;                          // why it cannot be used, as "is …"; empty if it can
  std::string version;                          // of the runtime
  Library library;                              // of the runtime
  std::map<std::string, std::string> problems;  // of single schedulers
};

/// Asks the module of `runtime` in a short-lived process, once: nothing of it stays in this one.
[[nodiscard]] const ModuleReport& module_report(const std::string& runtime);

/// Loads the module into this process, where it stays: runtimes keep threads of their own. How workers wait
/// is settled then, since runtimes read it only once. Throws SchedulerError if it cannot be loaded, if it
/// comes with another library than asked for, if another OpenMP runtime is there already (they would disturb
/// each other), or if it is loaded with other waiting.
const Module& load_module(const std::string& runtime, const SchedulerOptions& options);

struct SchedulerError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace raysweep
