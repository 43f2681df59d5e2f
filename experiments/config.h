// An experiment as its file states it. Parsing is a pure function of text and machine size; every error names
// file and line, and all are told at once.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cell.h"
#include "experiments/claims_config.h"
#include "schedulers/placement.h"

namespace raysweep {

/// Factors that advance together (one, unless zipped), and their values, as text.
struct SweepAxis {
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> points;  // each as long as `names`
};

struct Measure {
  int launches = 7;             // of each cell, at least
  int max_launches = 28;        // of a cell whose interval stays too wide
  int twins = 1;                // of one cell, for the noise floor
  bool bases = true;            // also serial, one thread and co-running copies, for speedups and ceilings
  double budget_seconds = 600;  // of the whole experiment, shared by its cells
  double interval = 0.02;       // relative half-width to reach
  double seconds = 0.3;         // timed frames of one launch
  double timeout_seconds = 0;   // of a launch; 0: a multiple of what the serial picture took
  uint64_t seed = 1;
};

struct Config {
  std::string file, text;  // text as run: with what --set changed
  std::string experiment, title;
  std::string scene = "chair-ball";
  std::vector<std::string> modes;  // empty: the default settings
  std::vector<SweepAxis> axes;
  Measure measure;
  ClaimsConfig claims;
  std::string not_here;  // why this machine cannot answer the question, as a sentence; empty if it can
};

/// The machine as far as a config refers to it.
struct MachineSize {
  int cores, pus;                                             // in ranges such as "1..2*pus"
  std::vector<int> processors{};                              // that may be pinned to; empty: any
  std::optional<HyperThreadingPlacements> hyper_threading{};  // none where there is none
};

/// Parses `text`; `file` is for messages and for paths relative to it; `overrides` are `key=value` as of
/// --set. Throws RequestError with one line per error.
[[nodiscard]] Config parse_config(const std::string& text, const std::string& file,
                                  const std::vector<std::string>& overrides, const MachineSize& machine);

/// The text of a config's file. Throws RequestError where there is none.
[[nodiscard]] std::string read_config_text(const std::string& file);

/// "1..4", "cores", "pus", "1..2*pus" or "8" as a list of numbers; empty if it is none of these or descends.
/// What refers to the machine never exceeds the largest thread count.
[[nodiscard]] std::vector<int> expand_range(const std::string& text, const MachineSize& machine);

/// What a value of factor `name` stands for on this machine: the numbers of a range, where it is numeric; of
/// isa "all", the instruction sets that run here, best first; else itself.
[[nodiscard]] std::vector<std::string> expand_value(const std::string& text, std::string_view name,
                                                    bool numeric, const MachineSize& machine);

/// "10 min", "90 s", "2 h" in seconds; 0 if it is none of these.
[[nodiscard]] double parse_duration(const std::string& text);

}  // namespace raysweep
