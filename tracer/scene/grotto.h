// A rock in a closed room: triangles and nothing else, and every ray hits one.
#pragma once

#include "tracer/scene/geodesic.h"

namespace raysweep {

inline constexpr int grotto_frequency = 100;

/// Of the rock and of the room.
inline constexpr size_t grotto_triangle_count = geodesic_triangle_count(grotto_frequency) + 12;

/// Lights and camera are inside. All surfaces mirror, so that paths end by depth alone.
[[nodiscard]] Scene make_grotto(int light_count);

}  // namespace raysweep
