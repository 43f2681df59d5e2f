// Asking for memory ahead of its use.
#if defined(RAYSWEEP_WIDE_FETCH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYSWEEP_WIDE_FETCH_INL_H_
#undef RAYSWEEP_WIDE_FETCH_INL_H_
#else
#define RAYSWEEP_WIDE_FETCH_INL_H_
#endif

#include "tracer/wide/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raysweep {
namespace HWY_NAMESPACE {

/// Whether a tree and its blocks are more than caches hold: only then is what packets visit next worth asking
/// for ahead. On a million triangles (120 MB) that makes them 3 to 7 % faster, on 200,000 (23 MB) it does not
/// matter, and on less it costs 4 to 9 %. Single rays, 48 in flight, it makes slower everywhere.
template <class Geometry>
HWY_INLINE bool is_large(const Geometry& geometry) {
  constexpr size_t cached = size_t{32} << 20;
  return geometry.tree.nodes.size() * sizeof(geometry.tree.nodes[0]) +
             geometry.blocks.size() * sizeof(geometry.blocks[0]) >
         cached;
}

/// Asks for a child that is to be visited when all others in flight have gone on.
template <class Node, class Block>
HWY_INLINE void fetch(const Node* nodes, const Block* blocks, WideChild child) {
  const bool is_leaf = (child & leaf_bit) != 0;
  const char* const from = is_leaf ? reinterpret_cast<const char*>(blocks + child_index(child))
                                   : reinterpret_cast<const char*>(nodes + child);
  for (size_t line = 0; line < sizeof(Block); line += 64)
    __builtin_prefetch(from + (is_leaf ? line : line % sizeof(Node)));  // a node is smaller
}

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#endif
