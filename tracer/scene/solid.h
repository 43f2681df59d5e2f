// Which shapes have an inside, and what is in it.
#pragma once

#include "tracer/scene/scene.h"

namespace raysweep {

/// The triangles of `mesh` by connected part, corners at equal places taken as one: places in
/// `mesh.triangles`.
[[nodiscard]] std::vector<std::vector<uint32_t>> connected_parts(const Mesh& mesh);

/// A mesh of these triangles of `mesh` alone.
[[nodiscard]] Mesh part_of(const Mesh& mesh, const std::vector<uint32_t>& triangles);

/// Whether every edge of `mesh`, corners at equal places taken as one, is run through as often in one
/// direction as in the other: then it bounds a volume. Triangles that are there with both windings are the
/// two faces of a sheet, and bound none.
[[nodiscard]] bool is_closed(const Mesh& mesh);

/// The enclosed volume, positive where triangles wind counterclockwise as seen from outside.
[[nodiscard]] double signed_volume(const Mesh& mesh);

/// Whether `point` lies inside. A mesh is asked for its winding number there, by solid angles (Van Oosterom &
/// Strackee 1983), which no edge or corner confuses.
[[nodiscard]] bool contains(const Mesh& mesh, const Vec3d& point);
[[nodiscard]] bool contains(const Sphere& sphere, const Vec3d& point);
[[nodiscard]] bool contains(const Plane& half_space, const Vec3d& point);

}  // namespace raysweep
