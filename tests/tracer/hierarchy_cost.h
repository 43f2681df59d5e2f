// What rays are expected to do in a hierarchy.
#pragma once

#include "tracer/accel/hierarchy.h"

namespace raysweep {

/// Expected visits and tests of a ray that meets the root, each weighted by its box's area.
inline double cost(const Hierarchy<float>& tree) {
  double sum = 0;
  for (const Node<float>& node : tree.nodes)
    sum += static_cast<double>(node.box.half_area()) * (node.is_leaf() ? node.count : 1);
  return sum / static_cast<double>(tree.nodes[0].box.half_area());
}

}  // namespace raysweep
