// Scenes from TOML files; README.md describes the format.
#pragma once

#include <string>

#include "tracer/scene/scene.h"
#include "tracer/scene/scenes.h"

namespace raysweep {

/// The scene that `file` describes; files that it names are found from its folder. Throws SceneError with all
/// that is wrong, one line each: `file:line: sentence`.
[[nodiscard]] Scene load_scene_file(const std::string& file);

}  // namespace raysweep
