#include "tracer/scene/scenes.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>

#include "tracer/scene/chair.h"
#include "tracer/scene/chair_ball.h"
#include "tracer/scene/cornell_glass.h"
#include "tracer/scene/grotto.h"
#include "tracer/scene/ice.h"
#include "tracer/scene/many_lights.h"
#include "tracer/scene/marbles.h"
#include "tracer/scene/pebble.h"
#include "tracer/scene/scene_file.h"
#include "tracer/scene/studio.h"

namespace raysweep {

namespace {

constexpr int mesh_light_count = 2;

const BuiltInScene* find_built_in(std::string_view name) {
  for (const BuiltInScene& scene : built_in_scenes()) {
    if (scene.name == name) return &scene;
  }
  return nullptr;
}

bool is_scene_file(const std::string& file) { return std::filesystem::path(file).extension() == ".toml"; }

void refuse_what_is_no_file(const std::string& file) {
  std::error_code error;
  if (std::filesystem::is_regular_file(file, error)) return;
  std::string names;
  for (const BuiltInScene& scene : built_in_scenes())
    names += fmt::format("{}{}", names.empty() ? "" : ", ", scene.name);
  throw SceneError(
      fmt::format("no scene \"{}\": it is neither built in (those are: {}) nor a scene or mesh file that can "
                  "be opened",
                  file, names));
}

Scene load_first_lights(const std::string& file, std::optional<int> light_count) {
  Scene scene = load_scene_file(file);
  if (!light_count) return scene;
  const auto count = static_cast<size_t>(*light_count);
  if (count > scene.lights.size()) {
    throw SceneError(
        fmt::format("{}: has {} lights, {} were asked for; ask for at most {} or add lights to it", file,
                    scene.lights.size(), count, scene.lights.size()));
  }
  scene.lights.resize(count);
  return scene;
}

}  // namespace

std::span<const BuiltInScene> built_in_scenes() {
  static constexpr std::array<BuiltInScene, 9> list{
      {{"chair-ball", "a mirror sphere beside a mirror chair of 10,817 triangles (Morozov 2011, 5.4)",
        chair_triangle_count, 1, 0, 1, make_chair_ball},
       {"studio", "the chair in lacquer with glossy balls on a studio sweep: the README's picture", 11416, 3,
        0, 3, make_studio},
       {"ice", "a block of ice with a hollow, half full of a liquid: three nested media", 1764, 49, 2, 2,
        make_ice},
       {"cornell-glass", "a room with glass around water around air, and media that touch", 34, 4, 0, 1,
        make_cornell_glass},
       {"many-lights", "a field of balls under 64 coloured lamps: shadow rays are nearly all of the work", 0,
        49, 1, 64, make_many_lights},
       {"marbles",
        "a heap of glass marbles in the corner of an empty picture: the cost of tiles is very uneven", 0, 150,
        0, 2, make_marbles},
       {"pebble", "a lumpy stone of as many triangles as the Stanford bunny, and nothing else",
        geodesic_triangle_count(pebble_frequency), 0, 0, 2, make_pebble},
       {"planet", "mountains of a million triangles, finer than the pixels of a small picture",
        geodesic_triangle_count(planet_frequency), 0, 0, 2, make_planet},
       {"grotto", "a rock in a closed room, all of triangles: every ray hits, and every hit mirrors",
        grotto_triangle_count, 0, 0, 2, make_grotto}}};
  return list;
}

Scene load_scene(const std::string& name_or_file, std::optional<int> light_count) {
  if (const BuiltInScene* const scene = find_built_in(name_or_file))
    return scene->make(light_count.value_or(scene->light_count));
  refuse_what_is_no_file(name_or_file);
  if (is_scene_file(name_or_file)) return load_first_lights(name_or_file, light_count);
  return frame_meshes(name_or_file, load_meshes(name_or_file), light_count.value_or(mesh_light_count));
}

int own_light_count(const std::string& name_or_file) {
  if (const BuiltInScene* const scene = find_built_in(name_or_file)) return scene->light_count;
  refuse_what_is_no_file(name_or_file);
  if (!is_scene_file(name_or_file)) return mesh_light_count;
  return static_cast<int>(load_scene_file(name_or_file).lights.size());
}

}  // namespace raysweep
