// A loop written by hand against a library, and the same through this project's schedulers: one process, in
// turns.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "schedulers/item_space.h"

namespace raysweep {

struct DirectLoop {
  std::string text;       // how it is written by hand
  std::string scheduler;  // that does the same
  std::function<void(size_t items, const Body& body)> run;
};

struct DirectProgram {
  std::string name;     // of the program
  std::string runtime;  // of the schedulers; empty: their only one
  std::vector<DirectLoop> (*loops)(int threads);
};

/// Parses the command line and compares each loop; the program's exit code.
int compare_directly(const DirectProgram& program, int argc, char** argv);

}  // namespace raysweep
