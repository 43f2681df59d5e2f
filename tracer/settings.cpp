#include "tracer/settings.h"

#include <array>
#include <vector>

#include "tracer/intersect/all.h"
#include "tracer/wide/isa.h"

namespace raysweep {

std::span<const Mode> modes() {
  static constexpr std::array<Mode, 4> list{{{"low", 512, 512, 1, 1, 1},
                                             {"middle", 800, 600, 2, 2, 1},
                                             {"hard", 1024, 768, 3, 4, 2},
                                             {"very_hard", 1920, 1080, 3, 8, 2}}};
  return list;
}

std::span<const Choice> cores() {
  static constexpr std::array<Choice, 3> list{
      {{"scalar", "flat nodes, nearer child first, cut off behind the nearest hit"},
       {"wide", "nodes of 4 or 8 children, many rays in flight, SIMD by --isa; float only"},
       {"m11", "Morozov 2011: recursive, pointer nodes, both children always visited, virtual primitives"}}};
  return list;
}

std::span<const Choice> accels() {
  static constexpr std::array<Choice, 4> list{
      {{"sah", "hierarchy by the surface area heuristic in 16 bins"},
       {"sbvh", "as sah, and planes may cut boxes in two (Stich, Friedrich & Dietrich 2009)"},
       {"median", "hierarchy that halves the longest axis (Morozov 2011)"},
       {"none", "every primitive for every ray: the oracle of the others"}}};
  return list;
}

std::span<const Choice> precisions() {
  static constexpr std::array<Choice, 2> list{{{"float", "32 bits"}, {"double", "64 bits"}}};
  return list;
}

std::span<const Choice> patterns() {
  static constexpr std::array<Choice, 5> list{
      {{"grid", "equal cells in rows; a count without near-equal factors gets rows of unequal length"},
       {"rotated_grid", "a lattice whose x and y are all different; 4 points are a turned regular grid"},
       {"circle",
        "points evenly on a circle (Morozov 2011); circle:RADIUS:PHASE, in pixels and in steps between "
        "points, "
        "else 1/sqrt(6) and 0.2"},
       {"halton", "the Halton sequence in the bases 2 and 3"},
       {"sobol", "the Sobol sequence, Owen-scrambled; sobol:SEED, else seed 0"}}};
  return list;
}

std::span<const Choice> methods() {
  static const std::vector<Choice> list = [] {
    std::vector<Choice> all;
    for_each_method([&](auto method) { all.push_back({method.name, method.summary}); });
    return all;
  }();
  return list;
}

std::span<const Choice> isas() {
  static const std::vector<Choice> list = [] {
    std::vector<Choice> all;
    for (const Isa& isa : built_isas()) all.push_back({isa.name, isa.summary});
    return all;
  }();
  return list;
}

}  // namespace raysweep
