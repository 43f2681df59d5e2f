// Which shapes have an inside, and what is in it.
#pragma once

#include "tracer/scene/scene.h"

namespace raysweep {

/// Whether every edge of `mesh`, corners at equal places taken as one, is run through as often in one
/// direction as in the other: then it bounds a volume.
[[nodiscard]] bool is_closed(const Mesh& mesh);

/// The enclosed volume, positive where triangles wind counterclockwise as seen from outside.
[[nodiscard]] double signed_volume(const Mesh& mesh);

/// Whether `point` lies inside. A mesh is asked for its winding number there, by solid angles (Van Oosterom &
/// Strackee 1983), which no edge or corner confuses.
[[nodiscard]] bool contains(const Mesh& mesh, const Vec3d& point);
[[nodiscard]] bool contains(const Sphere& sphere, const Vec3d& point);
[[nodiscard]] bool contains(const Plane& half_space, const Vec3d& point);

}  // namespace raysweep
