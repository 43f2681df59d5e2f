// Which scenes a test can afford.
#pragma once

#include <vector>

#include "tracer/scene/scenes.h"

namespace raysweep {

/// Brute force takes 10 ns a triangle and ray: with more triangles, hierarchies are compared with each other.
inline constexpr size_t brute_force_triangles = 20'000;

/// Making and looking at so many takes tenths of a second; sanitizers multiply that by 10 to 30.
inline constexpr size_t quick_triangles = 300'000;

/// Whether a scene has as many shapes as its entry in the list tells.
inline bool has_what_is_told(const Scene& scene, const BuiltInScene& told) {
  return scene.triangle_count() == told.triangle_count && scene.spheres.size() == told.sphere_count &&
         scene.planes.size() == told.plane_count;
}

/// The built-in scenes that have at most `most` triangles.
inline std::vector<BuiltInScene> scenes_up_to(size_t most) {
  std::vector<BuiltInScene> list;
  for (const BuiltInScene& scene : built_in_scenes()) {
    if (scene.triangle_count <= most) list.push_back(scene);
  }
  return list;
}

/// Those that brute force cannot take.
inline std::vector<BuiltInScene> large_scenes() {
  std::vector<BuiltInScene> list(built_in_scenes().begin(), built_in_scenes().end());
  std::erase_if(list, [](const BuiltInScene& s) { return s.triangle_count <= brute_force_triangles; });
  return list;
}

}  // namespace raysweep
