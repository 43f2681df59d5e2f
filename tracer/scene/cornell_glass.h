// A room with coloured walls, and in it glass around water around air.
#pragma once

#include "tracer/scene/scene.h"

namespace raysweep {

/// After the box of Goral et al. 1984: a ball of glass (1.5) with water (1.333) and a bubble of air (1.0) in
/// it, one inside the other; a glass block that a water ball touches with a gap of nothing; a mirror block.
/// The camera stands in the room.
[[nodiscard]] Scene make_cornell_glass(int light_count);

}  // namespace raysweep
