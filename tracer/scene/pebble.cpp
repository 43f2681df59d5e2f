#include "tracer/scene/pebble.h"

#include "tracer/scene/rock.h"

namespace raysweep {

namespace {

Scene in_the_open(const char* name, const Rock& rock, const Colour& colour) {
  Scene scene;
  scene.name = name;
  scene.materials = {{.ambient = colour,
                      .diffuse = colour,
                      .k_ambient = 0.1,
                      .k_diffuse = 1.1,
                      .k_specular = 0.4,
                      .exponent = 60,
                      .k_reflect = 0.3}};
  scene.meshes = {make_rock(rock)};
  scene.meshes[0].name = name;
  return scene;
}

}  // namespace

Scene make_pebble(int light_count) {
  Scene scene = in_the_open("pebble",
                            {.frequency = pebble_frequency,
                             .octaves = 4,
                             .lumps = 2.2,
                             .height = 0.36,
                             .roughness = 0.42,
                             .stretch = {1.25, 0.9, 0.9},
                             .seed = 40},
                            {0.36, 0.16, 0.07});
  scene.background = {0.66, 0.74, 0.80};
  scene.camera = {.position = {-1.4, 1.5, 4.4}, .target = {-0.06, 0, 0}, .half_angle = 0.22};
  scene.lights = light_dome(light_count, scene.camera.target, 6);
  return scene;
}

Scene make_planet(int light_count) {
  Scene scene = in_the_open(
      "planet",
      {.frequency = planet_frequency, .octaves = 6, .lumps = 3, .height = 0.2, .roughness = 0.5, .seed = 100},
      {0.55, 0.22, 0.09});
  scene.background = {0.10, 0.13, 0.20};
  scene.camera = {.position = {-1.2, 1.6, 4.2}, .target = {0, 0, 0}, .half_angle = 0.22};
  scene.lights = light_dome(light_count, scene.camera.target, 6);
  return scene;
}

}  // namespace raysweep
