#include "tracer/scene/scenes.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>

#include "tracer/scene/chair_ball.h"
#include "tracer/scene/studio.h"

namespace raysweep {

std::span<const BuiltInScene> built_in_scenes() {
  static constexpr std::array<BuiltInScene, 2> list{
      {{"chair-ball", "a mirror sphere beside a mirror chair of 10,817 triangles (Morozov 2011, 5.4)",
        make_chair_ball},
       {"studio", "the chair in lacquer with glossy balls on a studio sweep: the README's picture",
        make_studio}}};
  return list;
}

Scene load_scene(const std::string& name_or_file, int light_count) {
  std::string names;
  for (const BuiltInScene& scene : built_in_scenes()) {
    if (scene.name == name_or_file) return scene.make(light_count);
    names += fmt::format("{}{}", names.empty() ? "" : ", ", scene.name);
  }
  std::error_code error;
  if (!std::filesystem::is_regular_file(name_or_file, error)) {
    throw SceneError(
        fmt::format("no scene \"{}\": it is neither built in (those are: {}) nor a mesh file that can be "
                    "opened",
                    name_or_file, names));
  }
  return frame_meshes(name_or_file, load_meshes(name_or_file), light_count);
}

}  // namespace raysweep
