// Boxes with rounded edges: what blocks of ice and what they hold are made of.
#pragma once

#include <functional>

#include "tracer/scene/scene.h"

namespace raysweep {

struct RoundedBox {
  Vec3d lower, upper;
  double radius;  // of the edges; less than half the shortest side
  int arc = 2;    // cells across each half edge
  int flat = 4;   // cells across the flat middle of a face
  /// How far a point of the surface is moved along its normal; nothing for no dents. Equal points must give
  /// equal results.
  std::function<double(const Vec3d& point)> dent;
};

/// Appends the box: `12·(2·arc + flat)²` triangles, closed, wound counterclockwise as seen from outside.
void append_rounded_box(Mesh& mesh, const RoundedBox& box);

}  // namespace raysweep
