// The one list of ray–triangle methods. Renderer, command line, config parser and tests iterate it.
#pragma once

#include <tuple>

#include "tracer/intersect/moller_trumbore.h"
#include "tracer/intersect/morozov.h"
#include "tracer/intersect/woop_watertight.h"

namespace raysweep {

using Methods = std::tuple<MollerTrumbore, Morozov, WoopWatertight>;

/// Calls `visit(method)` with an object of each method in turn.
template <class Visit>
void for_each_method(Visit&& visit) {
  std::apply([&](auto... method) { (visit(method), ...); }, Methods{});
}

}  // namespace raysweep
