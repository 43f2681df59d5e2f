// From Assimp's materials to ours. Only mesh_file.cpp and its kind see this: without Assimp it is not built.
#pragma once

#include <assimp/material.h>

#include "tracer/scene/scene.h"

namespace raysweep {

/// What `source` tells that Phong's model can say; README.md has the table. Where it tells nothing, or what
/// cannot be (not finite, negative, a refractive index of 0), the value of a plain surface.
[[nodiscard]] Material take_over(const aiMaterial& source);

}  // namespace raysweep
