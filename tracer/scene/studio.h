// The README's picture: the chair, lacquered, with balls on a studio sweep.
#pragma once

#include "tracer/scene/scene.h"

namespace raysweep {

[[nodiscard]] Scene make_studio(int light_count);

}  // namespace raysweep
