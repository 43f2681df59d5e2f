#include "tracer/scene/moved.h"

namespace raysweep {

namespace {

/// The nearest float. Volatile, because GCC 12 forgets the rounding where its vectorizer takes two of them
/// together: from -O2 on, two neighbouring doubles that go through floats come out as they went in.
double rounded(double value) {
  const volatile float nearest = static_cast<float>(value);
  return nearest;
}

}  // namespace

Scene moved(Scene scene, const Vec3d& by) {
  const auto place = [&](const Vec3d& p) {
    return Vec3d(rounded(p.x + by.x), rounded(p.y + by.y), rounded(p.z + by.z));
  };
  for (Plane& plane : scene.planes) plane.offset = rounded(plane.offset - dot(plane.normal, by));
  for (Sphere& sphere : scene.spheres) {
    sphere.centre = place(sphere.centre);
    sphere.radius = rounded(sphere.radius);
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
