// The shapes of a scene file.
#pragma once

#include <filesystem>
#include <map>

#include "tracer/scene/scene_file_values.h"

namespace raysweep {

/// What objects refer to, and where they go.
struct SceneObjects {
  Scene& scene;
  const std::map<std::string, uint32_t, std::less<>>& materials;  // names to places in `scene.materials`
  std::filesystem::path folder;                                   // where mesh files are looked for
};

/// Adds the object that `table` describes, one of [[objects]], to the scene.
void add_object(const toml::table& table, const SceneObjects& objects, SceneErrors& errors);

}  // namespace raysweep
