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
inline constexpr uint32_t slot_count = 56;

/// Of a ray that needs no child next: a hit is to be looked at first.
inline constexpr WideChild candidate = ~WideChild{0};

/// Offsets of slots by what their rays need next: a node, a block of triangles, a hit looked at; those whose
/// rays have ended, and those that have none.
struct RayLists {
  struct List {
    uint32_t* slots;
    uint32_t count = 0;
  };
  List nodes, next_nodes, leaves, candidates, ended, empty;
  uint32_t* wanted;     // by rays just visited, in their order
  uint32_t* looked_at;  // slots of those whose hits were

  /// Numbers in the memory of all, with room for a vector of lanes stored at each one's end.
  static constexpr size_t list_size = slot_count + lane_count, size = 8 * list_size;

  /// Where in `memory`, which is a vector's, they end.
  HWY_INLINE uint32_t* place(uint32_t* memory) {
    for (List* list : {&nodes, &next_nodes, &leaves, &candidates, &ended, &empty}) {
      list->slots = memory;
      memory += list_size;
    }
    wanted = memory;
    looked_at = memory + list_size;
    return memory + 2 * list_size;
  }

  /// Adds `count` rays, which want what `wanted` says, to the lists. `slots` may be one of these that was
  /// emptied.
  HWY_INLINE void add(const uint32_t* slots, uint32_t count) {
    const Floats d;
    const Words dw;
    for (uint32_t i = 0; i < count; i += lane_count) {
      const WordLanes slot = hn::Load(dw, slots + i), next = hn::Load(dw, wanted + i);
      const auto is = [&](WideChild child)
                          HWY_ATTR { return hn::RebindMask(d, hn::Eq(next, hn::Set(dw, child))); };
      const LaneMask is_there = hn::RebindMask(d, hn::Lt(count_from(i), hn::Set(dw, count))),
                     is_candidate = is(candidate), is_end = is(sentinel),
                     is_node = hn::RebindMask(d, hn::Lt(next, hn::Set(dw, leaf_bit)));
      const auto add_to = [&](List& list, LaneMask which) HWY_ATTR {
        const Compaction kept(hn::And(which, is_there));
        hn::StoreU(kept(slot), dw, list.slots + list.count);
        list.count += kept.count();
      };
      add_to(next_nodes, is_node);
      add_to(candidates, is_candidate);
      add_to(ended, is_end);
      add_to(leaves, hn::Not(hn::Or(is_node, hn::Or(is_candidate, is_end))));
    }
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#endif
