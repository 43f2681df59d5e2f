#include "tracer/scene/marbles.h"

#include <array>

namespace raysweep {

namespace {

constexpr uint32_t glass = 0, bubble = 1, first_core = 2;

Material clear(double ior) {
  return {.k_ambient = 0,
          .k_diffuse = 0,
          .k_specular = 0.7,
          .exponent = 400,
          .k_refract = 0.97,
          .filter = {0.97, 0.99, 0.98},
          .ior = ior,
          .fresnel = true};
}

Material core(const Colour& colour) {
  return {.ambient = colour,
          .diffuse = colour,
          .k_ambient = 0.25,
          .k_diffuse = 0.85,
          .k_specular = 0.1,
          .k_reflect = 0.04};
}

/// A marble with a coloured core, and bubbles around it.
void add_marble(Scene& scene, const Vec3d& at, double radius, int number) {
  const auto colours = static_cast<int>(scene.materials.size() - first_core);
  const auto colour = first_core + static_cast<uint32_t>(number % colours);
  scene.spheres.push_back({at, radius, glass});
  scene.spheres.push_back({at, 0.45 * radius, colour});
  for (int i = 0; i < 3; ++i) {
    const double angle = 2.1 * i + number;
    const Vec3d towards(std::cos(angle), 0.4 * std::sin(3.0 * angle), std::sin(angle));
    scene.spheres.push_back({at + towards * (0.68 * radius), (0.09 + 0.03 * i) * radius, bubble});
  }
}

}  // namespace

Scene make_marbles(int light_count) {
  Scene scene;
  scene.name = "marbles";
  scene.materials = {clear(1.5),
                     clear(1.0),
                     core({0.85, 0.10, 0.08}),
                     core({0.95, 0.60, 0.05}),
                     core({0.08, 0.50, 0.20}),
                     core({0.06, 0.20, 0.70}),
                     core({0.55, 0.10, 0.55})};
  // A pyramid of marbles that touch: layers of 4 × 4, 3 × 3, 2 × 2 and one.
  constexpr double radius = 0.2;
  int number = 0;
  for (int layer = 0; layer < 4; ++layer) {
    const int side = 4 - layer;
    for (int i = 0; i < side; ++i) {
      for (int j = 0; j < side; ++j) {
        const Vec3d at(radius * (2 * i - side + 1), radius * (1 + layer * std::sqrt(2.0)),
                       radius * (2 * j - side + 1));
        add_marble(scene, at, radius, number++);
      }
    }
  }
  scene.background = {0.80, 0.84, 0.88};
  // The camera looks past them: they fill the lower right of the picture.
  scene.camera = {.position = {-1.6, 1.9, 4.4}, .target = {-0.62, 0.92, 0}, .half_angle = 0.27};
  scene.lights = light_dome(light_count, {0, 0.4, 0}, 6);
  return scene;
}

}  // namespace raysweep
