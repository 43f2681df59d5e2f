// A scene somewhere else.
#pragma once

#include "tracer/scene/scene.h"

namespace raysweep {

/// The scene moved by `by`, with every place, radius and plane rounded to floats, so that floats and doubles
/// trace the same scene and differ in their arithmetic alone. The camera looks in the direction that it did.
[[nodiscard]] Scene moved(Scene scene, const Vec3d& by);

}  // namespace raysweep
