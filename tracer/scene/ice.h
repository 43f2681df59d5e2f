// A block of ice with a hollow, and a liquid in the hollow (after a 2022 study of std::thread on ray
// tracing).
#pragma once

#include "tracer/scene/scene.h"

namespace raysweep {

/// Ice (1.31) around air (1.00) around liquid (1.333): three nested meshes, each of 588 triangles, and
/// bubbles in the ice.
[[nodiscard]] Scene make_ice(int light_count);

}  // namespace raysweep
