// The chair: legs, rails and spindles as closed parts, and one open woven seat. Deterministic.
#pragma once

#include "tracer/scene/scene.h"

namespace raysweep {

/// Triangles of the chair, as many as the one in Morozov 2011 has. A closed mesh has an even count; the odd
/// triangle comes from the woven seat, a declared open, two-sided sheet.
inline constexpr size_t chair_triangle_count = 10817;

/// Closed frame (even count) and open seat (odd count), in metres: feet at y = 0, seat at y = 0.45, front
/// towards +z, centred on x = z = 0.
struct Chair {
  Mesh frame, seat;
};

[[nodiscard]] Chair make_chair();

}  // namespace raysweep
