// The simplest of hierarchies: what a ray visits is known.
#pragma once

#include "tracer/scene/scene.h"

namespace raysweep {

/// Squares' lower halves one behind the other at z = 0, −1, …, none of them flat along an axis.
inline Scene triangles_in_a_row(uint32_t count) {
  Scene scene;
  scene.materials = {{}};
  Mesh mesh;
  for (uint32_t i = 0; i < count; ++i) {
    const float z = -static_cast<float>(i);
    mesh.vertices.insert(mesh.vertices.end(), {{-1, -1, z}, {1, -1, z + 0.1f}, {-1, 1, z + 0.2f}});
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  scene.meshes = {mesh};
  return scene;
}

}  // namespace raysweep
