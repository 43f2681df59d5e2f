// Glass marbles in the corner of an empty picture.
#pragma once

#include "tracer/scene/scene.h"

namespace raysweep {

/// Most tiles see the background, one ray a sample; some see glass inside glass, tens of rays: who hands out
/// tiles in equal shares waits for the slowest.
[[nodiscard]] Scene make_marbles(int light_count);

}  // namespace raysweep
