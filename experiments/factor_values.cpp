#include "experiments/factor_values.h"

#include <fmt/format.h>

#include <sstream>

#include "experiments/item.h"
#include "experiments/numbers.h"
#include "experiments/runtime_variables.h"
#include "schedulers/placement.h"
#include "schedulers/registry.h"
#include "tracer/sample/pattern.h"
#include "tracer/wide/isa.h"

namespace raysweep {

std::string set_int(const char* name, int& target, const std::string& value, Range range) {
  const auto number = parse_number<long long>(value);
  if (!number || !range.contains(*number)) {
    return fmt::format("{} = {} is {}: a whole number from {} to {} is possible", name, value,
                       number ? "out of range" : "not a whole number in range", range.low, range.high);
  }
  target = static_cast<int>(*number);
  return {};
}

std::string set_choice(const char* name, std::string& target, const std::string& value,
                       std::span<const Choice> choices) {
  std::string names;
  for (const Choice& choice : choices) {
    if (choice.name == value) {
      target = value;
      return {};
    }
    names += fmt::format("{}{}", names.empty() ? "" : ", ", choice.name);
  }
  return fmt::format("unknown {} \"{}\"; possible: {}", name, value, names);
}

std::string set_lights(Cell& cell, const std::string& value) {
  if (value == "scene") {
    cell.lights.reset();
    return {};
  }
  int count = 0;
  std::string problem = set_int("lights", count, value, lights_range);
  if (problem.empty()) cell.lights = count;
  return problem;
}

std::string set_pixel_tolerance(Cell& cell, const std::string& value) {
  const auto number = parse_number<double>(value);
  if (!number || !(*number >= 0 && *number <= 1)) {
    return fmt::format(
        "pixel_tolerance = {} is not possible: a number from 0 to 1, of the film's units, where 1 is white; "
        "0 ends no path early",
        value);
  }
  cell.settings.pixel_tolerance = *number;
  return {};
}

std::string set_slowdown(Cell& cell, const std::string& value) {
  const auto number = parse_number<double>(value);
  if (!number || !(*number >= 0 && *number <= 10)) {
    return fmt::format(
        "slowdown = {} is not possible: a number from 0 to 10, of a frame's time; 0 plants none", value);
  }
  cell.slowdown = *number;
  return {};
}

std::string set_method(Cell& cell, const std::string& value) {
  if (value != "auto") return set_choice("method", cell.settings.method, value, methods());
  return "method = \"auto\" is for `raysweep render`, which chooses by the scene; name the methods here, or "
         "ask "
         "`raysweep advise` which";
}

std::string set_pattern(Cell& cell, const std::string& value) {
  std::string problem = pattern_problem(value);
  if (problem.empty()) cell.settings.pattern = value;
  return problem;
}

std::string set_isa(Cell& cell, const std::string& value) {
  std::string names = "best";
  for (const Choice& isa : isas()) {
    if (runs_here(isa.name)) names += fmt::format(", {}", isa.name);
  }
  if (value != "best" && !runs_here(value))
    return fmt::format("isa \"{}\" cannot be used here; possible: {}", value, names);
  cell.settings.isa = value;
  return {};
}

std::string set_scheduler(Cell& cell, const std::string& value) {
  const SchedulerInfo* const info = find_scheduler(value);
  if (!info) {
    std::string names;
    for (const SchedulerInfo& known : all_schedulers()) {
      if (why_unavailable(known).empty()) names += fmt::format("{}{}", names.empty() ? "" : ", ", known.name);
    }
    return fmt::format("unknown scheduler \"{}\"; built here: {}", value, names);
  }
  if (const std::string problem = why_unavailable(*info); !problem.empty())
    return fmt::format("scheduler \"{}\" cannot be used here: it is {}", value, problem);
  cell.scheduler = value;
  return {};
}

std::string set_runtime(Cell& cell, const std::string& value) {
  std::string names = "default";
  for (const RuntimeInfo& known : all_runtimes()) {
    if (known.family != "openmp") continue;  // other families have one only
    names += fmt::format(", {}", known.name);
    if (known.name != value) continue;
    if (const std::string& problem = module_report(value).problem; !problem.empty())
      return fmt::format("runtime \"{}\" cannot be used here: it is {}", value, problem);
    cell.runtime = value;
    return {};
  }
  if (value != "default") return fmt::format("unknown runtime \"{}\"; possible: {}", value, names);
  cell.runtime = value;
  return {};
}

std::string set_item(Cell& cell, const std::string& value) {
  if (!parse_item(value)) {
    return fmt::format(
        "unknown item \"{}\"; possible: pixels, rows, columns, tiles, tiles:SIDE with a side from 1 to {}",
        value, max_tile_side);
  }
  cell.item = value;
  return {};
}

std::string set_chunk(Cell& cell, const std::string& value) {
  constexpr std::pair<std::string_view, Chunk::Unit> suffixes[] = {{"/thread", Chunk::Unit::per_thread},
                                                                   {"B", Chunk::Unit::bytes}};
  Chunk chunk;
  std::string_view digits = value;
  for (const auto& [suffix, unit] : suffixes) {
    if (!digits.ends_with(suffix)) continue;
    digits.remove_suffix(suffix.size());
    chunk.unit = unit;
    break;
  }
  const auto number = parse_number<int>(digits);
  if (!number || *number < 1 || *number > max_chunk) {
    return fmt::format(
        "chunk = {} is not possible: a count from 1 to {}, \"COUNT/thread\", or \"COUNTB\" for bytes of film",
        value, max_chunk);
  }
  chunk.value = *number;
  cell.chunk = chunk;
  return {};
}

std::string set_pin(Cell& cell, const std::string& value) {
  std::string problem = pin_problem(value, {});
  if (problem.empty()) cell.pin = value;
  return problem;
}

std::string set_spin_count(Cell& cell, const std::string& value) {
  if (value == "default") {
    cell.spin_count.reset();
    return {};
  }
  int count = 0;
  std::string problem = set_int("spin_count", count, value, {0, 1'000'000'000});
  if (problem.empty()) cell.spin_count = count;
  return problem;
}

std::string set_environment(Cell& cell, const std::string& value) {
  constexpr std::pair<std::string_view, std::string_view> factors[] = {{"OMP_WAIT_POLICY", "wait_policy"},
                                                                       {"GOMP_SPINCOUNT", "spin_count"}};
  std::istringstream in(value);
  for (std::string word; in >> word;) {
    const std::string name = word.substr(0, word.find('='));
    if (name == word || !is_runtime_variable(name)) {
      return fmt::format(
          "environment = \"{}\" is not possible: NAME=VALUE, separated by spaces, with names that begin with "
          "{}",
          value, fmt::join(runtime_variables(), ", "));
    }
    for (const auto& [variable, factor] : factors) {
      if (name == variable)
        return fmt::format("environment = \"{}\": {} has a factor of its own: {}", value, variable, factor);
    }
  }
  cell.environment = value;
  return {};
}

}  // namespace raysweep
