// Scenes by name, and scenes from files.
#pragma once

#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "tracer/scene/scene.h"

namespace raysweep {

/// A scene of this project's own making.
struct BuiltInScene {
  std::string_view name, summary;
  // Told here, so that who chooses among scenes need not make a million triangles.
  size_t triangle_count, sphere_count, plane_count;
  int light_count;  // its own; others can be asked for
  Scene (*make)(int light_count);
};

/// The one list of built-in scenes.
[[nodiscard]] std::span<const BuiltInScene> built_in_scenes();

/// The scene named `name_or_file`, or, if that is no built-in name, the one in that file: a scene in TOML, of
/// whose lights the first `light_count` are taken, or a mesh. Throws SceneError.
[[nodiscard]] Scene load_scene(const std::string& name_or_file, std::optional<int> light_count = {});

/// How many lights the scene itself has. Throws SceneError.
[[nodiscard]] int own_light_count(const std::string& name_or_file);

/// What is wrong with a scene, as a sentence that names it.
struct SceneError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Meshes of a file with their materials: each mesh's `material` indexes `materials`.
struct ImportedMeshes {
  std::vector<Mesh> meshes;
  std::vector<Material> materials;
};

/// Reads OBJ, PLY, STL, glTF and whatever else Assimp reads. Throws SceneError: unreadable, empty, NaN, bad
/// index. Values of materials that cannot be are replaced, never an error.
[[nodiscard]] ImportedMeshes load_meshes(const std::string& file);

/// Why mesh files cannot be read here; empty if they can.
[[nodiscard]] std::string why_no_mesh_files();

/// The light, slightly glossy surface of meshes whose file tells of none.
[[nodiscard]] Material plain_surface();

/// Looks from the front left at all of `box`, in pictures that are no higher than wide.
[[nodiscard]] Camera framing_camera(const Box<double>& box);

/// What was imported, moved to the origin, before a pale background, with a camera that frames it.
[[nodiscard]] Scene frame_meshes(std::string name, ImportedMeshes imported, int light_count);

}  // namespace raysweep
