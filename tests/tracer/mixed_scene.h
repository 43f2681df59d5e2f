// A small scene in which shapes of all kinds coincide.
#pragma once

#include "tracer/scene/scene.h"

namespace raysweep {

/// Planes, spheres and triangles, some of them twice: ties are everywhere.
inline Scene mixed_scene() {
  Scene scene;
  scene.name = "mixed";
  scene.materials = {{}};
  scene.planes = {{{0, 1, 0}, 0, 0}, {{0, 1, 0}, 0, 0}};
  scene.spheres = {{{0, 0.5, 0}, 0.5, 0}, {{0, 0.5, 0}, 0.5, 0}, {{0.6, 0.4, 0.3}, 0.2, 0}};
  Mesh mesh;
  mesh.vertices = {{-1, 0, -1}, {1, 0, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, 0, 1}, {1, 0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 1, 2}, {0, 1, 5}, {0, 5, 4}, {0, 0, 1}};
  scene.meshes = {mesh, mesh};
  scene.lights = light_dome(3, {0, 0.5, 0}, 4);
  scene.camera = {.position = {0.3, 1, 4}, .target = {0, 0.5, 0}, .half_angle = 0.4};
  return scene;
}

}  // namespace raysweep
