#include "tracer/scene/chair_ball.h"

#include "tracer/scene/chair.h"

namespace raysweep {

Scene make_chair_ball(int light_count) {
  Scene scene;
  scene.name = "chair-ball";
  scene.materials = {{.ambient = {0.30, 0.17, 0.10},
                      .diffuse = {0.42, 0.24, 0.14},
                      .specular = {1, 1, 1},
                      .k_ambient = 0.15,
                      .k_diffuse = 0.6,
                      .k_specular = 0.6,
                      .exponent = 60,
                      .k_reflect = 1},
                     {.ambient = {0.10, 0.12, 0.16},
                      .diffuse = {0.10, 0.13, 0.18},
                      .specular = {1, 1, 1},
                      .k_ambient = 0.15,
                      .k_diffuse = 0.6,
                      .k_specular = 0.8,
                      .exponent = 120,
                      .k_reflect = 1}};
  Chair chair = make_chair();
  scene.meshes = {std::move(chair.frame), std::move(chair.seat)};
  scene.spheres = {{{0.52, 0.3, 0.22}, 0.3, 1}};
  scene.background = {0.045, 0.065, 0.095};
  scene.camera = {.position = {-0.75, 1.05, 2.25}, .target = {0.18, 0.45, 0.0}, .half_angle = 0.27};
  scene.lights = light_dome(light_count, scene.camera.target, 4);
  return scene;
}

}  // namespace raysweep
