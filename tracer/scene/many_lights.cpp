#include "tracer/scene/many_lights.h"

#include <numbers>

namespace raysweep {

namespace {

/// A pure hue, 0 ≤ hue < 1 from red over green and blue back to red, as bright as the others.
Colour of_hue(double hue) {
  const auto channel = [hue](double peak) {
    return 0.5 + 0.5 * std::cos(2 * std::numbers::pi * (hue - peak));
  };
  return {channel(0), channel(1.0 / 3), channel(2.0 / 3)};
}

/// Lamps on a spiral from the middle outwards; neighbours differ in hue by the golden ratio. Together they
/// give white of strength 2.2 whatever their count.
std::vector<Light> lamps(int count) {
  constexpr double golden = 0.6180339887498949;
  std::vector<Light> lights;
  Colour sum;
  for (int i = 0; i < count; ++i) {
    const double radius = 0.9 + 3.2 * std::sqrt((i + 0.5) / count), angle = 2 * std::numbers::pi * golden * i;
    const Vec3d at(radius * std::cos(angle), 1.3 + 1.1 * std::fmod(golden * 3 * i, 1.0),
                   radius * std::sin(angle));
    lights.push_back({at, of_hue(std::fmod(golden * i, 1.0))});
    sum += lights.back().intensity;
  }
  for (Light& light : lights) {
    light.intensity = {2.2 * light.intensity.x / sum.x, 2.2 * light.intensity.y / sum.y,
                       2.2 * light.intensity.z / sum.z};
  }
  return lights;
}

}  // namespace

Scene make_many_lights(int light_count) {
  Scene scene;
  scene.name = "many-lights";
  const Material ball{.ambient = {0.9, 0.9, 0.9},
                      .diffuse = {0.9, 0.9, 0.9},
                      .specular = {1, 1, 1},
                      .k_ambient = 0.02,
                      .k_diffuse = 0.62,
                      .k_specular = 0.5,
                      .exponent = 90,
                      .k_reflect = 0.12};
  Material floor = ball;
  floor.diffuse = floor.ambient = {0.75, 0.75, 0.78};
  floor.k_specular = 0;
  floor.k_reflect = 0.06;
  scene.materials = {floor, ball};
  scene.planes = {{{0, 1, 0}, 0, 0}};
  for (int row = -3; row <= 3; ++row) {
    for (int column = -3; column <= 3; ++column) {
      const double radius = 0.17 + 0.11 * std::abs(std::sin(12.9898 * row + 78.233 * column));
      const double x = 0.82 * column + (row % 2 == 0 ? 0.0 : 0.41);
      scene.spheres.push_back({{x, radius, 0.72 * row}, radius, 1});
    }
  }
  scene.background = {0.015, 0.02, 0.035};
  scene.camera = {.position = {0.6, 3.0, 5.6}, .target = {0.05, 0.1, -0.2}, .half_angle = 0.36};
  scene.lights = lamps(light_count);
  return scene;
}

}  // namespace raysweep
