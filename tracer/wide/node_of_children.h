// A wide node from its children, with their order as seen from each octant.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "tracer/accel/references.h"
#include "tracer/accel/triangle_face.h"
#include "tracer/wide/wide_tree.h"

namespace raysweep {

/// What a wide node leads to.
template <int width>
struct Children {
  std::array<WideChild, width> what;
  std::array<Box<float>, width> box;
  size_t count = 0;
  void add(WideChild child, const Box<float>& around) {
    what[count] = child;
    box[count++] = around;
  }
  /// Puts those first that are larger than half of `node`, where rays that any hit will do visit them last:
  /// hardly any is missed, and most hide nothing, as the walls of a room.
  void put_large_ones_first(const Box<float>& node) {
    const float large = node.half_area() / 2;
    for (size_t i = 1; i < count; ++i) {
      if (box[i].half_area() > large) {
        std::rotate(what.begin(), what.begin() + i, what.begin() + i + 1);
        std::rotate(box.begin(), box.begin() + i, box.begin() + i + 1);
      }
    }
  }
};

/// Sets the children's numbers from far to near for each octant, by the boxes' centres along its diagonal;
/// slots without a child count as farthest. Octants are compared side by side, four at a time.
template <int width>
void set_far_to_near(const std::array<Vec3<float>, width>& centres, size_t count, WideNode<width>& node) {
  constexpr float inf = std::numeric_limits<float>::infinity();
  constexpr Lanes<float> never{inf, inf, inf, inf};
  for (size_t first = 0; first < 8; first += 4) {
    std::array<Lanes<float>, width> along;
    along.fill(never);
    for (size_t i = 0; i < count; ++i) {
      const auto& [x, y, z] = centres[i];
      const float towards = first == 0 ? z : -z;
      const Lanes<float> sum = Lanes<float>{x, -x, x, -x} + Lanes<float>{y, y, -y, -y} + towards;
      along[i] = sum < never ? sum : never;  // infinite boxes may have centres that are no numbers
    }
    std::array<Counts<float>, width> rank{};
    for (size_t i = 0; i < width; ++i) {
      for (size_t j = i + 1; j < width; ++j) {
        const Counts<float> is_behind = along[j] > along[i];  // −1 where it is
        rank[i] -= is_behind;
        rank[j] += is_behind + 1;
      }
    }
    for (size_t lane = 0; lane < 4; ++lane) {
      uint32_t packed = 0;
      for (uint32_t i = 0; i < width; ++i) packed |= i << (rank[i][lane] * WideNode<width>::order_bits);
      node.far_to_near[first + lane] = packed;
    }
  }
}

/// A box whose planes lie by 4 units of rounding further out, so that kernels may compare rays with them less
/// exactly; what is added outweighs underflow where rays are regular. An empty box stays as it is.
[[nodiscard]] inline Box<float> widened(const Box<float>& box) {
  if (box.lower().x > box.upper().x) return box;
  const auto by = [](const Vec3f& planes) {
    const auto of = [](float plane) { return std::abs(plane) * (4 * unit_roundoff<float>)+0x1p-85f; };
    return Vec3f(of(planes.x), of(planes.y), of(planes.z));
  };
  return {{box.lower() - by(box.lower()), box.upper() + by(box.upper())}};
}

/// Slots without a child hold an empty box and the sentinel.
template <int width>
[[nodiscard]] WideNode<width> node_of(const Children<width>& children) {
  WideNode<width> n;
  std::array<Vec3<float>, width> centres;
  for (size_t i = 0; i < width; ++i) {
    const Box<float> box = i < children.count ? widened(children.box[i]) : Box<float>();
    for (int axis = 0; axis < 3; ++axis) {
      n.bounds[axis][0][i] = box.lower()[axis];
      n.bounds[axis][1][i] = box.upper()[axis];
    }
    n.children[i] = i < children.count ? children.what[i] : leaf_bit;
    centres[i] = box.centre();
  }
  set_far_to_near<width>(centres, children.count, n);
  return n;
}

}  // namespace raysweep
