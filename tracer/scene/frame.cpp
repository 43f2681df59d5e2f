#include "tracer/scene/scenes.h"

namespace raysweep {

Scene frame_meshes(std::string name, std::vector<Mesh> meshes, int light_count) {
  Scene scene;
  scene.name = std::move(name);
  scene.materials = {{.ambient = {0.9, 0.88, 0.85},
                      .diffuse = {0.9, 0.88, 0.85},
                      .k_ambient = 0.12,
                      .k_diffuse = 0.75,
                      .k_specular = 0.15,
                      .exponent = 40,
                      .k_reflect = 0.08}};
  scene.background = {0.62, 0.70, 0.80};
  Box<double> box;
  for (const Mesh& mesh : meshes) box.include(bounds_of(mesh));
  scene.meshes = std::move(meshes);

  // Around the origin floats are finest: a small thing far out keeps its shadows.
  const Vec3d centre(0, 0, 0), shift = box.centre();
  for (Mesh& mesh : scene.meshes) {
    for (Vec3f& vertex : mesh.vertices) vertex = Vec3f(Vec3d(vertex) - shift);
  }
  // The sphere around the box, a little larger, fills the smaller side of a 4:3 picture; a mesh of no extent
  // still needs a distance to look from.
  const double radius = std::max(0.5 * length(box.size()), 1e-6 * std::max(1.0, max_abs(centre)));
  const double distance = 1.05 * radius / std::sin(scene.camera.half_angle);
  scene.camera.target = centre;
  scene.camera.position = centre + distance * normalize(Vec3d(-0.45, 0.35, 1.0));
  scene.lights = light_dome(light_count, centre, 4 * radius);
  return scene;
}

}  // namespace raysweep
