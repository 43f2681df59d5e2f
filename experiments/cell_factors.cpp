#include "experiments/cell_factors.h"

#include <fmt/format.h>

#include <array>
#include <vector>

#include "experiments/errors.h"
#include "experiments/factor_values.h"
#include "experiments/item.h"
#include "schedulers/registry.h"

namespace raysweep {

namespace {

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
    CellFactor{"method", "see `raysweep list methods`", false, set_method,
               [](const Cell& c) { return c.settings.method; }},
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
