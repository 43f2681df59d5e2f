// How a family of schedulers comes as a module: a shared library loaded on demand, after the launch's
// environment is set, so that a process holds no runtime that it does not measure.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "schedulers/scheduler.h"

namespace raysweep {

/// One scheduler of a module.
struct ModuleEntry {
  std::string_view name;
  std::unique_ptr<Scheduler> (*make)(int threads);
};

/// What a module offers.
struct Module {
  std::vector<ModuleEntry> schedulers;
  std::string runtime;  // library, version, file
};

/// The only symbol that a module exports: `extern "C" const Module* raysweep_module()`.
using ModuleFunction = const Module* (*)();
inline constexpr const char* module_symbol = "raysweep_module";

/// The file of the shared library that holds the code at `address`, by dladdr; empty if there is none.
[[nodiscard]] std::string library_of(const void* address);

}  // namespace raysweep
