// Meshes of plain shape, and where a mesh stands.
#pragma once

#include "tracer/scene/scene.h"

namespace raysweep {

/// Appends the box between two corners, `lower` below `upper` on every axis: 12 triangles, closed, wound
/// counterclockwise as seen from outside.
void append_box(Mesh& mesh, const Vec3d& lower, const Vec3d& upper);

/// Scales about the origin, turns about the x, then the y, then the z axis, then moves. Angles are in
/// degrees, counterclockwise as seen from the axis' tip.
struct Placement {
  double scale = 1;
  Vec3d rotate, translate;
};

/// Puts `mesh` there. Vertices may overflow: who takes numbers from outside checks them afterwards.
void transform(Mesh& mesh, const Placement& placement);

}  // namespace raysweep
