// Morozov's reference scene (2011, 5.4): a mirror sphere and a mirror chair.
#pragma once

#include "tracer/scene/scene.h"

namespace raysweep {

/// Both shapes are ideal mirrors (`k_reflect` = 1) with a local colour of their own, so that lights are seen
/// and cost.
[[nodiscard]] Scene make_chair_ball(int light_count);

}  // namespace raysweep
