// A rock alone in the open, in two sizes that other ray tracers are measured on: triangles and nothing else.
#pragma once

#include "tracer/scene/geodesic.h"

namespace raysweep {

/// About as many as the Stanford bunny's 69,451.
inline constexpr int pebble_frequency = 59;
/// About a million.
inline constexpr int planet_frequency = 224;

/// Lumps that shadow and mirror each other, in front of a pale background.
[[nodiscard]] Scene make_pebble(int light_count);

/// The same with more and finer octaves, before a dark background: at 800 × 600, most triangles are smaller
/// than a pixel.
[[nodiscard]] Scene make_planet(int light_count);

}  // namespace raysweep
