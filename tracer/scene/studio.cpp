#include "tracer/scene/studio.h"

#include <numbers>

#include "tracer/scene/chair.h"
#include "tracer/scene/sweep.h"

namespace raysweep {

namespace {

/// Floor and back wall in one sheet, joined by a quarter of a cylinder: no horizon.
Mesh make_backdrop() {
  constexpr double half_width = 12, front = 8, bend_at = -2.2, radius = 2, height = 8;
  constexpr double floor_length = front - bend_at, bend_length = radius * std::numbers::pi / 2;
  constexpr int across = 3, along = 100;
  Mesh mesh;
  mesh.name = "backdrop";
  append_sheet(
      mesh,
      [](double u, double v) {
        const double x = half_width * (2 * u - 1);
        // Most of the cells go into the bend, where the sheet is curved.
        if (v < 0.1) return Vec3d(x, 0, front - floor_length * v / 0.1);
        if (v > 0.9) return Vec3d(x, radius + (height - radius) * (v - 0.9) / 0.1, bend_at - radius);
        const double angle = (v - 0.1) / 0.8 * bend_length / radius;
        return Vec3d(x, radius - radius * std::cos(angle), bend_at - radius * std::sin(angle));
      },
      across, along);
  return mesh;
}

Material paint(const Colour& colour, double k_reflect, double exponent) {
  return {.ambient = colour,
          .diffuse = colour,
          .specular = {1, 1, 1},
          .k_ambient = 0.16,
          .k_diffuse = 0.84,
          .k_specular = 0.5,
          .exponent = exponent,
          .k_reflect = k_reflect};
}

}  // namespace

Scene make_studio(int light_count) {
  Scene scene;
  scene.name = "studio";
  Material sweep = paint({0.17, 0.22, 0.28}, 0.14, 20);
  sweep.k_specular = 0;
  Material mirror = paint({0.05, 0.05, 0.06}, 0.88, 200);
  mirror.k_specular = 1;
  scene.materials = {sweep,  paint({0.62, 0.045, 0.03}, 0.06, 80), paint({0.78, 0.54, 0.26}, 0, 10),
                     mirror, paint({0.90, 0.48, 0.02}, 0.08, 90),  paint({0.02, 0.20, 0.30}, 0.14, 90)};
  Chair chair = make_chair();
  chair.frame.material = 1;
  chair.seat.material = 2;
  scene.meshes = {make_backdrop(), std::move(chair.frame), std::move(chair.seat)};
  scene.spheres = {
      {{0.62, 0.26, 0.02}, 0.26, 3}, {{-0.44, 0.12, 0.38}, 0.12, 4}, {{0.24, 0.085, 0.56}, 0.085, 5}};
  scene.background = {0.06, 0.08, 0.11};
  scene.camera = {.position = {-1.0, 1.15, 2.9}, .target = {0.10, 0.44, 0.0}, .half_angle = 0.22};
  scene.lights = light_dome(light_count, scene.camera.target, 5);
  return scene;
}

}  // namespace raysweep
