// Boxes to build hierarchies of.
#pragma once

#include <algorithm>
#include <random>
#include <vector>

#include "tracer/accel/hierarchy.h"

namespace raysweep {

inline Box<float> box_at(float x, float y, float z, float size = 0.01f) {
  Box<float> box;
  box.include({x, y, z});
  box.include({x + size, y + size, z + size});
  return box;
}

inline std::vector<Box<float>> scattered(int count) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(-1, 1);
  std::vector<Box<float>> items;
  for (int i = 0; i < count; ++i) items.push_back(box_at(uniform(random), uniform(random), uniform(random)));
  return items;
}

inline uint32_t largest_leaf(const Hierarchy<float>& tree) {
  uint32_t largest = 0;
  for (const Node<float>& node : tree.nodes) largest = std::max(largest, node.count);
  return largest;
}

}  // namespace raysweep
