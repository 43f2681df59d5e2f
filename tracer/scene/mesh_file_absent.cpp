// Stands in for mesh_file.cpp where Assimp was not found.
#include "tracer/scene/scenes.h"

namespace raysweep {

std::string why_no_mesh_files() { return "built without Assimp; install libassimp-dev and build again"; }

ImportedMeshes load_meshes(const std::string& file) {
  throw SceneError(file + ": mesh files cannot be read here: " + why_no_mesh_files());
}

}  // namespace raysweep
