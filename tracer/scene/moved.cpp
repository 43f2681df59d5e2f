#include "tracer/scene/moved.h"

namespace raysweep {

Scene moved(Scene scene, const Vec3d& by) {
  const auto place = [&](const Vec3d& p) { return Vec3d(Vec3f(p + by)); };
  for (Plane& plane : scene.planes) plane.offset = static_cast<float>(plane.offset - dot(plane.normal, by));
  for (Sphere& sphere : scene.spheres) {
    sphere.centre = place(sphere.centre);
    sphere.radius = static_cast<float>(sphere.radius);
  }
  for (Mesh& mesh : scene.meshes) {
    for (Vec3f& vertex : mesh.vertices) vertex = Vec3f(Vec3d(vertex) + by);
  }
  for (Light& light : scene.lights) light.position = place(light.position);
  const Vec3d view = scene.camera.target - scene.camera.position;
  scene.camera.position = place(scene.camera.position);
  scene.camera.target = scene.camera.position + view;
  return scene;
}

}  // namespace raysweep
