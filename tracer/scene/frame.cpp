#include "tracer/scene/scenes.h"

namespace raysweep {

namespace {

/// The sphere around the box; what has no extent still needs a distance to look from.
double framed_radius(const Box<double>& box) {
  return std::max(0.5 * length(box.size()), 1e-6 * std::max(1.0, max_abs(box.centre())));
}

}  // namespace

Material plain_surface() {
  return {.ambient = {0.9, 0.88, 0.85},
          .diffuse = {0.9, 0.88, 0.85},
          .k_ambient = 0.12,
          .k_diffuse = 0.75,
          .k_specular = 0.15,
          .exponent = 40,
          .k_reflect = 0.08};
}

Camera framing_camera(const Box<double>& box) {
  Camera camera;
  // A little larger than the sphere, which fills the smaller side of a 4:3 picture.
  const double distance = 1.05 * framed_radius(box) / std::sin(camera.half_angle);
  camera.target = box.centre();
  camera.position = camera.target + distance * normalize(Vec3d(-0.45, 0.35, 1.0));
  return camera;
}

Scene frame_meshes(std::string name, ImportedMeshes imported, int light_count) {
  Scene scene;
  scene.name = std::move(name);
  scene.materials = std::move(imported.materials);
  scene.background = {0.62, 0.70, 0.80};
  Box<double> box;
  for (const Mesh& mesh : imported.meshes) box.include(bounds_of(mesh));
  scene.meshes = std::move(imported.meshes);

  // Around the origin floats are finest: a small thing far out keeps its shadows.
  const Vec3d shift = box.centre(), half_size = 0.5 * box.size();
  for (Mesh& mesh : scene.meshes) {
    for (Vec3f& vertex : mesh.vertices) vertex = Vec3f(Vec3d(vertex) - shift);
  }
  Box<double> moved;
  moved.include(-half_size);
  moved.include(half_size);
  scene.camera = framing_camera(moved);
  scene.lights = light_dome(light_count, scene.camera.target, 4 * framed_radius(moved));
  return scene;
}

}  // namespace raysweep
