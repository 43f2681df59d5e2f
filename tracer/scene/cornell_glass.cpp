#include "tracer/scene/cornell_glass.h"

#include "tracer/scene/shapes.h"

namespace raysweep {

namespace {

enum : uint32_t { white, red, green, glass, water, air, mirror };

Material matt(const Colour& colour) {
  return {.ambient = colour, .diffuse = colour, .k_ambient = 0.3, .k_diffuse = 0.9, .k_specular = 0};
}

Material clear(double ior, const Colour& filter) {
  return {.k_ambient = 0,
          .k_diffuse = 0,
          .k_specular = 0.6,
          .exponent = 400,
          .k_refract = 0.98,
          .filter = filter,
          .ior = ior,
          .fresnel = true};
}

/// A wall of two triangles with the corner `at` and the sides `u` and `v`.
Mesh wall(const char* name, const Vec3d& at, const Vec3d& u, const Vec3d& v, uint32_t material) {
  Mesh mesh;
  mesh.name = name;
  mesh.material = material;
  for (const Vec3d& corner : {at, at + u, at + u + v, at + v}) mesh.vertices.emplace_back(corner);
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

Mesh block(const char* name, const Vec3d& size, const Placement& place, uint32_t material) {
  Mesh mesh;
  mesh.name = name;
  mesh.material = material;
  append_box(mesh, {-size.x / 2, 0, -size.z / 2}, {size.x / 2, size.y, size.z / 2});
  transform(mesh, place);
  return mesh;
}

/// `count` lights in rows under the ceiling; together they are as bright as one.
std::vector<Light> ceiling_lights(int count) {
  std::vector<Light> lights;
  const int columns = static_cast<int>(std::ceil(std::sqrt(count)));
  const int rows = columns > 0 ? (count + columns - 1) / columns : 0;
  for (int i = 0; i < count; ++i) {
    const int column = i % columns, row = i / columns;
    const double x = (column + 0.5) / columns - 0.5, z = (row + 0.5) / rows - 0.5;
    lights.push_back({{0.6 * x, 1.93, 0.6 * z}, Colour(0.86, 0.80, 0.70) * (1.0 / count)});
  }
  return lights;
}

}  // namespace

Scene make_cornell_glass(int light_count) {
  Scene scene;
  scene.name = "cornell-glass";
  scene.materials.resize(7);
  scene.materials[white] = matt({0.73, 0.72, 0.68});
  scene.materials[red] = matt({0.63, 0.06, 0.05});
  scene.materials[green] = matt({0.12, 0.45, 0.10});
  scene.materials[glass] = clear(1.5, {0.97, 1.0, 0.98});
  scene.materials[water] = clear(1.333, {0.85, 0.95, 1.0});
  scene.materials[air] = clear(1.0, {1, 1, 1});
  scene.materials[mirror] = {.ambient = {0.9, 0.9, 0.92},
                             .diffuse = {0.9, 0.9, 0.92},
                             .k_ambient = 0.02,
                             .k_diffuse = 0.03,
                             .k_specular = 0.8,
                             .exponent = 200,
                             .k_reflect = 0.9};

  scene.meshes = {
      wall("floor", {-1, 0, 3}, {2, 0, 0}, {0, 0, -4}, white),
      wall("ceiling", {-1, 2, -1}, {2, 0, 0}, {0, 0, 4}, white),
      wall("back wall", {-1, 0, -1}, {2, 0, 0}, {0, 2, 0}, white),
      wall("left wall", {-1, 0, -1}, {0, 2, 0}, {0, 0, 4}, red),
      wall("right wall", {1, 0, -1}, {0, 0, 4}, {0, 2, 0}, green),
      block("mirror", {0.55, 1.25, 0.55}, {.rotate = {0, 20, 0}, .translate = {-0.42, 0, -0.5}}, mirror),
      block("glass", {0.5, 0.5, 0.4}, {.rotate = {0, -16, 0}, .translate = {-0.45, 0, 0.42}}, glass)};
  // One in the other, then a ball of water that stands on the block of glass and touches it in one point.
  scene.spheres = {{{0.4, 0.42, 0.15}, 0.42, glass},
                   {{0.4, 0.42, 0.15}, 0.34, water},
                   {{0.36, 0.5, 0.2}, 0.16, air},
                   {{-0.45, 0.7, 0.42}, 0.2, water}};
  scene.camera = {.position = {0, 1.0, 4.6}, .target = {0, 0.93, 0}, .half_angle = 0.275};
  scene.lights = ceiling_lights(light_count);
  return scene;
}

}  // namespace raysweep
