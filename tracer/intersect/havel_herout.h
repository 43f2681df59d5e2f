// Havel & Herout 2010, "Yet faster ray–triangle intersection (using SSE4)".
#pragma once

#include "tracer/intersect/perpendicular_planes.h"

namespace raysweep {

/// The constants are those of the perpendicular planes, found anew two years later; what is new is that the
/// point is scaled by det, so that only hits are divided.
struct HavelHerout : PerpendicularPlanes {
  static constexpr std::string_view name = "havel_herout";
  static constexpr std::string_view summary =
      "Havel & Herout 2010; perpendicular planes precomputed, divides late";
  static constexpr Division division = Division::late;
};

}  // namespace raysweep
