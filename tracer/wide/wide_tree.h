// A hierarchy with as many children a node, and as many triangles a block, as a vector has lanes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tracer/accel/hierarchy.h"
#include "tracer/for_each.h"
#include "tracer/ray_batch.h"
#include "tracer/unset_memory.h"

namespace raysweep {

/// A child: an inner node's index, or, with `leaf_bit` set, the index of a leaf's first block; with
/// `sphere_bit` too, of a block of spheres.
using WideChild = uint32_t;
inline constexpr WideChild leaf_bit = 0x80000000, sphere_bit = 0x40000000;
inline constexpr WideChild child_index(WideChild child) { return child & ~(leaf_bit | sphere_bit); }

/// The boxes of `width` children, structure of arrays; a child that is not there has an empty box. For width
/// 8: four cache lines.
template <int width>
struct alignas(64) WideNode {
  static constexpr int order_bits = 3;  // to number up to 8 children

  float bounds[3][2][width];  // [axis][0]: lower bounds, [axis][1]: upper ones; a bit wider than the boxes
  WideChild children[width];
  /// For each octant of directions (bit 0: towards lower x, bit 1: y, bit 2: z) the children's numbers from
  /// far to near, `order_bits` each, the farthest in the lowest bits.
  uint32_t far_to_near[8];
};

/// Up to `width` primitives of one leaf, in the first `count` lanes; the others hold `no_hit_id`. Lanes
/// without a triangle hold corners of NaN, which no method hits. Of triangles all that decides on hits:
/// nothing else is fetched until one is shaded.
template <int width>
struct alignas(64) WideBlock {
  float corners[9][width];  // x, y, z of A, of B, of C
  uint32_t id[width];
  uint32_t count;
  uint32_t more;                                          // 1 if the leaf goes on in the next block
  alignas(sizeof(float) * width) float normal[3][width];  // TriangleShape's
};

/// `blocks[0]` of a tree is the sentinel: no primitives.
template <int width>
struct WideTree {
  UnsetVector<WideNode<width>> nodes;
  /// What the blocks hold: `width` items each, `no_hit_id` where there is none.
  UnsetVector<uint32_t> block_items;
  std::vector<uint8_t> block_goes_on;
  int depth = 0;        // inner nodes on the longest path
  double cost = 0;      // expected visits a ray: nodes and blocks, each weighted by the chance to be met
  Box<float> bounds;    // of everything, as much wider as nodes'
  bool is_cut = false;  // items lie in several leaves

  /// Entries that any traversal's stack may need.
  [[nodiscard]] size_t stack_size() const { return size_t{width - 1} * static_cast<size_t>(depth) + 2; }
};

/// Which items are spheres, and whether leaves may be made larger than the hierarchy's own.
struct CollapseOptions {
  uint32_t sphere_count;  // items 0 … sphere_count − 1
  bool merges_leaves;     // up to one block a leaf; otherwise the hierarchy's leaves stay what they are
};

/// The cheapest way to pull children of a binary hierarchy up into nodes of `width` and to end in leaves
/// (Ylitie, Karras & Laine 2017, "Efficient incoherent ray traversal on GPUs through compressed wide BVHs",
/// section 3.1: dynamic programming over the surface area heuristic). Leaves hold either triangles or
/// spheres. `boxes` are the items'; an empty `hierarchy` gives one leaf of all of them. `for_each` shares the
/// work.
template <int width>
[[nodiscard]] WideTree<width> collapse(const Hierarchy<float>& hierarchy, std::span<const Box<float>> boxes,
                                       const CollapseOptions& options,
                                       const ForEach& for_each = one_after_the_other);

}  // namespace raysweep
