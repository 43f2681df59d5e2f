// The geodesic sphere: closed meshes of any number of triangles, all of about one size.
#pragma once

#include <functional>

#include "tracer/scene/scene.h"

namespace raysweep {

/// Each of the icosahedron's 20 faces is cut into `frequency`² triangles.
[[nodiscard]] constexpr size_t geodesic_triangle_count(int frequency) {
  return 20 * static_cast<size_t>(frequency) * static_cast<size_t>(frequency);
}

/// Appends a geodesic sphere, closed, wound counterclockwise as seen from outside. Neighbours share their
/// vertices, 10·`frequency`² + 2 of them; `place` is asked once for each: where does the one in this
/// direction (of length 1) go? Needs `frequency` ≥ 1.
void append_geodesic(Mesh& mesh, int frequency, const std::function<Vec3d(const Vec3d& direction)>& place);

}  // namespace raysweep
