#include "experiments/cell_factors.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <vector>

#include "experiments/errors.h"
#include "experiments/item.h"
#include "experiments/numbers.h"
#include "experiments/runtime_variables.h"
#include "schedulers/placement.h"
#include "schedulers/registry.h"
#include "tracer/sample/pattern.h"
#include "tracer/wide/isa.h"

namespace raysweep {

namespace {

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

/// A count, or "scene" for the scene's own.
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

/// Only what runtimes read when they are loaded, since other variables would be too late for this process;
/// and not what has a factor of its own.
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

constexpr std::array<Choice, 3> wait_policies_list{Choice{"default", "as the runtime likes"},
                                                   Choice{"active", "idle workers spin"},
                                                   Choice{"passive", "idle workers sleep at once"}};
std::span<const Choice> wait_policies() { return wait_policies_list; }

std::vector<Choice> order_choices() {
  std::vector<Choice> choices;
  for (const OrderInfo& order : item_orders()) choices.push_back({order.name, order.summary});
  return choices;
}

#define RAYSWEEP_INT(name, member, range, possible)                                                        \
  CellFactor {                                                                                             \
    name, possible, true, [](Cell& c, const std::string& v) { return set_int(name, c.member, v, range); }, \
        [](const Cell& c) { return std::to_string(c.member); }                                             \
  }
#define RAYSWEEP_CHOICE(name, member, list)                                                  \
  CellFactor {                                                                               \
    name, "see `raysweep list " #list "`", false,                                            \
        [](Cell& c, const std::string& v) { return set_choice(name, c.member, v, list()); }, \
        [](const Cell& c) { return c.member; }                                               \
  }

constexpr Range threads_range{min_threads, max_threads};

const std::array factors{
    CellFactor{"scene", "a built-in name, a scene file (.toml) or a mesh file", false,
               [](Cell& c, const std::string& v) {
                 c.scene = v;
                 return std::string();
               },
               [](const Cell& c) { return c.scene; }},
    RAYSWEEP_INT("width", settings.width, width_range, "pixels"),
    RAYSWEEP_INT("height", settings.height, height_range, "pixels"),
    RAYSWEEP_INT("subpixels", settings.subpixels, subpixels_range, "samples a pixel"),
    CellFactor{"pattern", "see `raysweep list patterns`", false, set_pattern,
               [](const Cell& c) { return c.settings.pattern; }},
    RAYSWEEP_INT("depth", settings.depth, depth_range, "1 to 1024; primary hits are depth 1"),
    CellFactor{"pixel_tolerance", "what ending paths early may take from a pixel: 0 to 1, 0 ends none", true,
               set_pixel_tolerance,
               [](const Cell& c) { return fmt::format("{}", c.settings.pixel_tolerance); }},
    RAYSWEEP_INT("branches", settings.branches, branches_range, "rays that a sample may trace through glass"),
    CellFactor{"lights", "0 to 64, or scene for as many as it has", true, set_lights,
               [](const Cell& c) { return c.lights_text(); }},
    RAYSWEEP_CHOICE("accel", settings.accel, accels),
    RAYSWEEP_INT("leaf", settings.leaf, leaf_range,
                 "primitives a leaf holds at most; with core wide and accel sah, a block"),
    RAYSWEEP_CHOICE("core", settings.core, cores),
    RAYSWEEP_CHOICE("method", settings.method, methods),
    RAYSWEEP_CHOICE("precision", settings.precision, precisions),
    CellFactor{"isa", "instruction set of the core wide: best, or see `raysweep list isas`", false, set_isa,
               [](const Cell& c) { return c.settings.isa; }},
    CellFactor{"scheduler", "see `raysweep list schedulers`", false, set_scheduler,
               [](const Cell& c) { return c.scheduler; }},
    RAYSWEEP_INT("threads", threads, threads_range, "1 to 1024"),
    CellFactor{"runtime", "of omp_*: libgomp or libomp, see `raysweep list runtimes`", false, set_runtime,
               [](const Cell& c) { return c.runtime; }},
    CellFactor{"item", "pixels, rows, columns, tiles or tiles:SIDE", false, set_item,
               [](const Cell& c) { return c.item; }},
    CellFactor{"order", "of items: scanline, morton, hilbert or lpt (longest first, by the last frame)",
               false,
               [](Cell& c, const std::string& v) { return set_choice("order", c.order, v, order_choices()); },
               [](const Cell& c) { return c.order; }},
    CellFactor{"chunk", "handed out at once: COUNT items, COUNT/thread, or COUNTB bytes of film", true,
               set_chunk, [](const Cell& c) { return c.chunk.text(); }},
    CellFactor{"pin", "see `raysweep list pins`", false, set_pin, [](const Cell& c) { return c.pin; }},
    CellFactor{"wait_policy", "what idle workers do: default, active or passive", false,
               [](Cell& c, const std::string& v) {
                 return set_choice("wait_policy", c.wait_policy, v, wait_policies());
               },
               [](const Cell& c) { return c.wait_policy; }},
    CellFactor{"spin_count", "how often idle workers look before they sleep: default or a number", true,
               set_spin_count,
               [](const Cell& c) { return c.spin_count ? std::to_string(*c.spin_count) : "default"; }},
    CellFactor{"environment", "for the runtime: NAME=VALUE NAME=VALUE", false, set_environment,
               [](const Cell& c) { return c.environment; }},
    CellFactor{"slowdown", "planted: each frame is made longer by this share of its time", true, set_slowdown,
               [](const Cell& c) { return fmt::format("{}", c.slowdown); }},
};

#undef RAYSWEEP_INT
#undef RAYSWEEP_CHOICE

}  // namespace

std::span<const CellFactor> cell_factors() { return factors; }

const CellFactor* find_factor(std::string_view name) {
  for (const CellFactor& factor : factors) {
    if (factor.name == name) return &factor;
  }
  return nullptr;
}

void set_factor(Cell& cell, const CellFactor& factor, const std::string& value) {
  if (const std::string problem = factor.set(cell, value); !problem.empty()) throw RequestError(problem);
}

void refuse_impossible(const Cell& cell, const std::string& where) {
  const RenderSettings& s = cell.settings;
  if (s.core != "wide" || s.precision == "float") return;
  throw RequestError(fmt::format(
      "{}{}core = \"wide\" computes in float, not in precision = \"{}\": choose float, or the core "
      "scalar or m11 for this precision (in a sweep, [sweep.zip] advances both together)",
      where, where.empty() ? "" : ": ", s.precision));
}

void set_mode(Cell& cell, const std::string& mode) {
  std::string names;
  for (const Mode& m : modes()) {
    names += fmt::format("{}{}", names.empty() ? "" : ", ", m.name);
    if (m.name != mode) continue;
    cell.mode = mode;
    cell.settings.width = m.width;
    cell.settings.height = m.height;
    cell.settings.subpixels = m.subpixels;
    cell.settings.depth = m.depth;
    cell.lights = m.lights;
    return;
  }
  throw RequestError(fmt::format("unknown mode \"{}\"; possible: {}", mode, names));
}

}  // namespace raysweep
