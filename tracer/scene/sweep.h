// Surfaces from moving a cross-section along a path: what chairs are made of.
#pragma once

#include <functional>

#include "tracer/scene/scene.h"

namespace raysweep {

/// A place on a path, 0 ≤ u ≤ 1: the section's centre, its two half axes (not unit: their lengths are the
/// radii), and its squareness (2 is an ellipse, more is boxier).
struct Section {
  Vec3d centre, half_a, half_b;
  double squareness = 2;
};
using Path = std::function<Section(double u)>;

/// Appends a tube of `around` sides and `along` segments with flat caps: `2·around·along + 2·(around − 2)`
/// triangles, closed.
void append_tube(Mesh& mesh, const Path& path, int around, int along);

/// Appends a closed ring, `path(0) = path(1)`: `2·around·along` triangles, closed.
void append_ring(Mesh& mesh, const Path& path, int around, int along);

/// Appends the open sheet `point(u, v)`, `across × along` quads without one corner triangle:
/// `2·across·along − 1` triangles.
void append_sheet(Mesh& mesh, const std::function<Vec3d(double u, double v)>& point, int across, int along);

}  // namespace raysweep
