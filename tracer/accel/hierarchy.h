// A bounding volume hierarchy over boxes, and its builders.
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

/// `nodes[0]` is the root; no nodes where there are no items. `order` holds every item once, or in several
/// leaves where items were cut, but in no leaf twice.
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

/// How items may be cut.
struct CutOptions {
  uint32_t whole_count = 0;  // items 0 … whole_count − 1 are not
  double more = 0.5;         // as many references as items may be added, × this
};

/// The surface area heuristic, where planes may also cut items in two (Stich, Friedrich & Dietrich 2009,
/// "Spatial splits in bounding volume hierarchies"), so that boxes overlap less. Otherwise as build_sah.
///
/// Unlike in the paper, an item's box is cut, not the triangle in it: where a ray and a triangle meet but for
/// rounding, `accept` in primitives.h holds the hit anywhere inside the triangle's whole box, off the
/// triangle too, and a box drawn tightly around a piece of the triangle would lose it. Cut in this way,
/// nothing is lost, whatever the ray, the triangle and their rounding. Let `slab` find `enter ≤ t ≤ leave` in
/// a box that is cut at a plane, which the ray meets at f as `slab` computes it. In both pieces f is the same
/// number, and takes the place of one end of one axis' interval. If t ≤ f, the piece before the plane has f
/// as a far end: still no far end, widened, is before t ≥ 0. If t ≥ f, the piece behind the plane has f as a
/// near end: still none is after t. If f is no number, both pieces leave it out. So each hit lies in a piece
/// of the item's box, and all boxes above enclose that piece.
template <class T>
[[nodiscard]] Hierarchy<T> build_sbvh(std::span<const Box<T>> items, const CutOptions& options, int leaf_size,
                                      int block = 1, const ForEach& for_each = one_after_the_other);

}  // namespace raysweep
