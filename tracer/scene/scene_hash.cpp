// A scene's fingerprint: everything that a picture of it depends on, member by member.
#include "tracer/hash.h"
#include "tracer/scene/scene.h"

namespace raysweep {

namespace {

void add(Hash& hash, const Vec3d& v) {
  for (int axis = 0; axis < 3; ++axis) hash.add(v[axis]);
}

void add(Hash& hash, const Material& m) {
  for (const Colour& c : {m.ambient, m.diffuse, m.specular, m.filter}) add(hash, c);
  for (const double k : {m.k_ambient, m.k_diffuse, m.k_specular, m.exponent, m.k_reflect, m.k_refract, m.ior})
    hash.add(k);
  hash.add(m.fresnel);
  hash.add(m.priority);
}

void add(Hash& hash, const Mesh& mesh) {
  hash.add(mesh.vertices.size());
  hash.add_bytes(mesh.vertices.data(), mesh.vertices.size() * sizeof(Vec3f));
  hash.add(mesh.triangles.size());
  hash.add_bytes(mesh.triangles.data(), mesh.triangles.size() * sizeof(mesh.triangles[0]));
  hash.add(mesh.material);
}

void add(Hash& hash, const Plane& plane) {
  add(hash, plane.normal);
  hash.add(plane.offset);
  hash.add(plane.material);
}

void add(Hash& hash, const Sphere& sphere) {
  add(hash, sphere.centre);
  hash.add(sphere.radius);
  hash.add(sphere.material);
}

void add(Hash& hash, const Light& light) {
  add(hash, light.position);
  add(hash, light.intensity);
}

template <class T>
void add(Hash& hash, const std::vector<T>& list) {
  hash.add(list.size());
  for (const T& entry : list) add(hash, entry);
}

}  // namespace

std::string scene_hash(const Scene& scene) {
  static_assert(sizeof(Vec3f) == 3 * sizeof(float), "vertices must have no padding");
  Hash hash;
  add(hash, scene.materials);
  add(hash, scene.planes);
  add(hash, scene.spheres);
  add(hash, scene.meshes);
  add(hash, scene.lights);
  add(hash, scene.ambient);
  add(hash, scene.background);
  add(hash, scene.camera.position);
  add(hash, scene.camera.target);
  add(hash, scene.camera.up);
  hash.add(scene.camera.half_angle);
  return hash.text();
}

}  // namespace raysweep
