// A loop written by hand against a library, and the same through this project's schedulers: one process, in
// turns.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "schedulers/item_space.h"

namespace raysweep {

struct DirectLoop {
  std::string text;       // how it is written by hand
  std::string scheduler;  // that does the same
  /// Hands each chunk to `body`; a loop whose chunks only the compiler knows does each item's work itself.
  std::function<void(size_t items, const Body& body, std::uint64_t item_iterations)> run;
};

struct DirectProgram {
  std::string name;     // of the program
  std::string runtime;  // of the schedulers; empty: their only one
  std::vector<DirectLoop> (*loops)(int threads);
};

/// Parses the command line and compares each loop; the program's exit code.
int compare_directly(const DirectProgram& program, int argc, char** argv);

}  // namespace raysweep
