// How a family of schedulers comes as a module: a shared library loaded on demand, after the launch's
// environment is set, so that a process holds no runtime that it does not measure.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "schedulers/options.h"
#include "schedulers/scheduler.h"

namespace raysweep {

/// Makes a scheduler with its workers; they may be cold.
using MakeScheduler = std::unique_ptr<Scheduler> (*)(const SchedulerOptions& options);

/// One scheduler of a module.
struct ModuleEntry {
  std::string_view name;
  MakeScheduler make;
  std::string_view problem{};  // why it cannot be made, as "is …"; then `make` is null
};

/// A shared library.
struct Library {
  std::string file, build_id;  // the linker's fingerprint, in hexadecimal digits: versions may share a name
};

/// Differs between programs and modules that were built of different sources and would misread each other.
inline constexpr size_t shared_layout =
    ((sizeof(WorkerEntry) * 4096 + sizeof(WorkerLog)) * 4096 + sizeof(SchedulerOptions)) * 4096 +
    sizeof(ItemSpace);

/// What a module offers.
struct Module {
  size_t layout = 0;  // shared_layout
  std::vector<ModuleEntry> schedulers;
  std::string version;  // of the runtime, as far as it tells one
  Library library;      // of the runtime that this process really uses
};

/// The only symbol that a module exports: `extern "C" const Module* raysweep_module()`.
using ModuleFunction = const Module* (*)();
inline constexpr const char* module_symbol = "raysweep_module";

/// The shared library that holds the code at `address`, by dladdr; empty if there is none.
[[nodiscard]] Library library_of(const void* address);

}  // namespace raysweep
