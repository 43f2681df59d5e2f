// Rays in flight, sorted by what they need next.
#if defined(RAYSWEEP_WIDE_RAY_LISTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYSWEEP_WIDE_RAY_LISTS_INL_H_
#undef RAYSWEEP_WIDE_RAY_LISTS_INL_H_
#else
#define RAYSWEEP_WIDE_RAY_LISTS_INL_H_
#endif

#include "tracer/wide/stacks-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raysweep {
namespace HWY_NAMESPACE {

/// Rays in flight: enough to hide latency and to make the lists' ends rare, few enough to stay in the first
/// cache.
inline constexpr uint32_t slot_count = 64;

/// Of a ray that needs no child next: a hit is to be looked at first.
inline constexpr WideChild candidate = ~WideChild{0};

/// Offsets of slots by what their rays need next: a node, a block of triangles, a hit looked at; those whose
/// rays have ended, and those that have none.
class RayLists {
 public:
  struct List {
    uint32_t* slots;
    uint32_t count = 0;
  };
  List nodes, next_nodes, leaves, candidates, looked_at, ended, empty;

  /// Numbers in the memory of all.
  static constexpr size_t size() { return 7 * 2 * list_size; }

  /// Where in `memory`, which is a vector's, they end.
  HWY_INLINE uint32_t* place(uint32_t* memory) {
    for (List* list : {&nodes, &next_nodes, &leaves, &candidates, &looked_at, &ended, &empty}) {
      list->slots = memory;
      memory += 2 * list_size;
    }
    return memory;
  }

  /// Where what the rays of a list want is written when they have been visited, in their order: so near that
  /// loops need no register for it.
  HWY_INLINE static uint32_t* wanted(uint32_t* slots) { return slots + list_size; }

  /// Adds the first `count` rays of a list to the lists of what they want. It may be one of these that was
  /// emptied.
  template <bool may_be_candidates>
  HWY_INLINE void add(uint32_t* slots, uint32_t count) {
    const Floats d;
    const Words dw;
    List to_nodes = next_nodes, to_leaves = leaves, to_candidates = candidates, to_ended = ended;
    for (uint32_t i = 0; i < count; i += lane_count) {
      const WordLanes slot = hn::Load(dw, slots + i), next = hn::Load(dw, wanted(slots) + i);
      const auto is = [&](WideChild child)
                          HWY_ATTR { return hn::RebindMask(d, hn::Eq(next, hn::Set(dw, child))); };
      const LaneMask is_there = hn::RebindMask(d, hn::Lt(count_from(i), hn::Set(dw, count))),
                     is_node = hn::RebindMask(d, hn::Lt(next, hn::Set(dw, leaf_bit)));
      const auto add_to = [&](List& list, LaneMask which) HWY_ATTR {
        const Compaction kept(hn::And(which, is_there));
        hn::StoreU(kept(slot), dw, list.slots + list.count);
        list.count += kept.count();
      };
      LaneMask is_no_leaf = hn::Or(is_node, is(sentinel));
      add_to(to_nodes, is_node);
      add_to(to_ended, is(sentinel));
      if constexpr (may_be_candidates) {
        add_to(to_candidates, is(candidate));
        is_no_leaf = hn::Or(is_no_leaf, is(candidate));
      }
      add_to(to_leaves, hn::Not(is_no_leaf));
    }
    next_nodes = to_nodes;
    leaves = to_leaves;
    candidates = to_candidates;
    ended = to_ended;
  }

 private:
  /// With room for a vector of lanes stored at a list's end.
  static constexpr size_t list_size = slot_count + lane_count;
};

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#endif
