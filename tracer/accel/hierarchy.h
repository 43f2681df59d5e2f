// A bounding volume hierarchy over boxes, and its two builders.
#pragma once

#include <cstdint>
#include <span>

#include "tracer/for_each.h"
#include "tracer/math/box.h"
#include "tracer/unset_memory.h"

namespace raysweep {

/// Inner node: `count` = 0, children at `first` and `first + 1`. Leaf: items `order[first … first + count)`.
template <class T>
struct Node {
  Box<T> box;
  uint32_t first = 0, count = 0;
  [[nodiscard]] bool is_leaf() const { return count > 0; }
};

/// `nodes[0]` is the root; no nodes where there are no items. `order` holds every item once.
template <class T>
struct Hierarchy {
  UnsetVector<Node<T>> nodes;
  UnsetVector<uint32_t> order;
};

/// No path from the root is longer than this: builders halve the count of items from `balanced_from_depth`
/// on, and 32 more levels separate 2³² items. It bounds every traversal stack.
inline constexpr int balanced_from_depth = 56;
inline constexpr int max_hierarchy_depth = balanced_from_depth + 33;

/// Morozov 2011, 4.3: halve the node's box in the middle of its longest axis, until a node holds at most
/// `leaf_size` items. Where that leaves one side empty, the box around the items' centres is halved instead;
/// items whose centres all coincide stay together in one leaf.
template <class T>
[[nodiscard]] Hierarchy<T> build_median(std::span<const Box<T>> items, int leaf_size);

/// The surface area heuristic in bins (Wald 2007, "On fast construction of SAH-based bounding volume
/// hierarchies"): at most `leaf_size` items a leaf, fewer where splitting is cheaper; items whose centres all
/// coincide stay together in one leaf. `block` items, a power of two, are tested at once and cost as much as
/// one. `for_each` shares the work.
template <class T>
[[nodiscard]] Hierarchy<T> build_sah(std::span<const Box<T>> items, int leaf_size, int block = 1,
                                     const ForEach& for_each = one_after_the_other);

}  // namespace raysweep
