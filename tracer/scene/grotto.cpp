#include "tracer/scene/grotto.h"

#include "tracer/scene/rock.h"
#include "tracer/scene/shapes.h"

namespace raysweep {

namespace {

Material polished(const Colour& colour, double k_reflect) {
  return {.ambient = colour,
          .diffuse = colour,
          .k_ambient = 0.15,
          .k_diffuse = 0.8,
          .k_specular = 0.3,
          .exponent = 60,
          .k_reflect = k_reflect};
}

}  // namespace

Scene make_grotto(int light_count) {
  Scene scene;
  scene.name = "grotto";
  scene.materials = {polished({0.22, 0.34, 0.42}, 0.3), polished({0.70, 0.36, 0.10}, 0.4)};
  Mesh room;
  room.name = "room";
  append_box(room, {-2.6, -1.5, -2.4}, {2.6, 2.3, 4.6});
  Mesh rock = make_rock({.frequency = grotto_frequency,
                         .octaves = 5,
                         .lumps = 2,
                         .height = 0.3,
                         .roughness = 0.4,
                         .stretch = {1.1, 1, 1},
                         .seed = 200});
  rock.name = "rock";
  rock.material = 1;
  scene.meshes = {std::move(room), std::move(rock)};
  scene.camera = {.position = {-1.3, 0.9, 4.3}, .target = {0, 0, 0}, .half_angle = 0.33};
  scene.lights = light_dome(light_count, {0, 0, 0}, 2.2);
  return scene;
}

}  // namespace raysweep
