// A field of balls under up to 64 coloured lamps.
#pragma once

#include "tracer/scene/scene.h"

namespace raysweep {

/// Every hit asks every light in front of it: shadow rays are nearly all of the work.
[[nodiscard]] Scene make_many_lights(int light_count);

}  // namespace raysweep
