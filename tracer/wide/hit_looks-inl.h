// Hits that a method has found, looked at: as many rays together as vectors have lanes.
#if defined(RAYSWEEP_WIDE_HIT_LOOKS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYSWEEP_WIDE_HIT_LOOKS_INL_H_
#undef RAYSWEEP_WIDE_HIT_LOOKS_INL_H_
#else
#define RAYSWEEP_WIDE_HIT_LOOKS_INL_H_
#endif

#include "tracer/wide/nearest-inl.h"
#include "tracer/wide/ray_setup-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raysweep {
namespace HWY_NAMESPACE {

/// Decides for rays whether what they may hit in a block counts, and what they need next.
template <class Method, bool any>
class HitLooks {
 public:
  using Block = WideBlock<lane_count>;

  HWY_INLINE HitLooks(const Primitives<float, Method>& primitives, const Block* blocks, const Stacks& stacks)
      : primitives_(primitives), blocks_(blocks), stacks_(stacks) {}

  /// Looks at the candidates of the first `count` slots of a vector of `candidates`. Writes vectors of slots,
  /// the first one instead of others, and of what their rays want.
  HWY_INLINE void look_at(char* slots, char* distances, const uint32_t* candidates, uint32_t count,
                          uint32_t* offsets, uint32_t* wanted) const {
    const Words dw;
    const auto is_there = hn::Lt(count_from(0), hn::Set(dw, count));
    hn::Store(hn::IfThenElse(is_there, hn::Load(dw, candidates), hn::Set(dw, candidates[0])), dw, offsets);
    const Hits hits = find(slots, distances, offsets);
    const uint32_t nearer = keep_nearer(hits, slots, offsets);
    for (uint32_t i = 0; i < count; ++i) {
      Slot& slot = slot_at(slots, offsets[i]);
      const uint32_t is_nearer = (nearer >> i) & 1;
      if constexpr (any) {
        // Not by a condition, which nobody can guess.
        const uint32_t ends = 0u - is_nearer;
        wanted[i] = (slot.current & ~ends) | (sentinel & ends);
      } else {
        if (is_nearer != 0) cut_off(slot);
        wanted[i] = slot.current;
      }
    }
    for (uint32_t left = hits.others & ((1u << count) - 1); left != 0; left &= left - 1) {
      const size_t i = hwy::Num0BitsBelowLS1Bit_Nonzero32(left);
      Slot& slot = slot_at(slots, offsets[i]);
      wanted[i] = keep(nearest_of(slot, Distances::of(offsets[i], distances).t), slot);
    }
  }

 private:
  HWY_INLINE static Slot& slot_at(char* slots, uint32_t offset) {
    return *reinterpret_cast<Slot*>(slots + offset);
  }

  /// One of each ray. Others, a bit each, are not what nearly all are: the only hit of a regular ray in a
  /// block of triangles.
  struct Hits {
    AcceptedHits<Floats> hits;
    WordLanes id;
    uint32_t others;
  };

  HWY_INLINE Hits find(char* slots, char* distances, const uint32_t* offsets) const {
    const Floats d;
    const float* corner[lane_count];
    const float* distance[lane_count];
    uint32_t others = 0;
    for (uint32_t i = 0; i < lane_count; ++i) {
      const Slot& slot = slot_at(slots, offsets[i]);
      const float* const of_slot = Distances::of(offsets[i], distances).t;
      const uint32_t hits = hits_at(of_slot), more = (hits & (hits - 1)) | (hits == 0 ? 1u : 0u) |
                                                     slot.is_flat |
                                                     (Method::is_watertight ? undecided_at(of_slot) : 0);
      others |= (more != 0 ? 1u : 0u) << i;
      const size_t lane = hwy::Num0BitsBelowLS1Bit_Nonzero32(hits | 1u << (lane_count - 1));
      corner[i] = blocks_[slot.block].corners[0] + lane;
      distance[i] = of_slot + lane;
    }
    const auto row = [&](size_t number) HWY_ATTR { return gather(Floats(), corner, number * lane_count); };
    const auto point = [&](size_t first) HWY_ATTR {
      return Lanes3<Floats>{row(first), row(first + 1), row(first + 2)};
    };
    constexpr size_t row_bytes = lane_count * sizeof(float), normal_row = offsetof(Block, normal) / row_bytes,
                     id_row = offsetof(Block, id) / row_bytes;
    const Corners<Floats> corners{point(0), point(3), point(6)};
    return {accept(Method{}, d, load_by_slot(slots, offsets, &Slot::origin).xyz(),
                   load_by_slot(slots, offsets, &Slot::direction).xyz(),
                   load_by_slot(slots, offsets, &Slot::reciprocal).xyz(), boxes_of(d, corners), corners,
                   point(normal_row), gather(d, distance, 0)),
            hn::BitCast(Words(), row(id_row)), others};
  }

  /// A bit for each ray that had nothing nearer.
  HWY_INLINE static uint32_t keep_nearer(const Hits& found, char* slots, const uint32_t* offsets) {
    const Floats d;
    const Words dw;
    const auto [y, z, t, id] = load_by_slot(slots, offsets, &Slot::reciprocal, 1);
    LaneMask is_nearer = hn::Lt(found.hits.t, t);
    if constexpr (!any)
      is_nearer = hn::Or(is_nearer, hn::And(hn::Eq(found.hits.t, t),
                                            hn::RebindMask(d, hn::Lt(found.id, hn::BitCast(dw, id)))));
    is_nearer = hn::AndNot(mask_of(found.others), hn::And(is_nearer, found.hits.accepted));
    store_by_slot(d, slots, offsets, &Slot::reciprocal, 1, y, z, hn::IfThenElse(is_nearer, found.hits.t, t),
                  hn::IfThenElse(is_nearer, hn::BitCast(d, found.id), id));
    return bits_of(is_nearer);
  }

  /// What lies behind the hit.
  HWY_INLINE void cut_off(Slot& slot) const {
    stacks_.shorten_after_block(slot, slot.t * widening, blocks_[slot.block].more);
  }

  /// The first hit of the block's candidates, whatever they are.
  HWY_NOINLINE HWY_ATTR Hit<float> nearest_of(const Slot& slot, const float* distances) const {
    const Block& block = blocks_[slot.block];
    if (block.id[0] < primitives_.first_triangle()) return nearest_sphere(slot, block);
    if (slot.is_flat != 0) return nearest_of_flat(slot, block, distances);
    const auto by_axis = [](const float* v) HWY_ATTR { return hn::InsertLane(hn::Load(Axes(), v), 3, v[0]); };
    const OneRay ray{by_axis(slot.origin), by_axis(slot.direction), by_axis(slot.reciprocal),
                     slot.longest_axis};
    return nearest_triangle(primitives_, block, ray, distances);
  }

  /// What the ray needs next.
  HWY_INLINE WideChild keep(const Hit<float>& hit, Slot& slot) const {
    if (!(any ? hit.t < slot.t : hit.before({slot.t, slot.id}))) return slot.current;
    slot.t = hit.t;
    slot.id = hit.id;
    if constexpr (any) return sentinel;
    cut_off(slot);
    return slot.current;
  }

  HWY_INLINE Hit<float> nearest_of_flat(const Slot& slot, const Block& block, const float* distances) const {
    const RayOfSlot ray(slot);
    return nearest_one_by_one(primitives_, block, ray.ray, ray.slab_ray, distances,
                              hits_at(distances) | undecided_at(distances), Hit<float>::none());
  }

  HWY_INLINE Hit<float> nearest_sphere(const Slot& slot, const Block& block) const {
    const RayOfSlot ray(slot);
    Hit<float> nearest = Hit<float>::none();
    for (uint32_t lane = 0; lane < block.count; ++lane) {
      const auto t = primitives_.intersect_sphere(block.id[lane], ray.ray, ray.slab_ray, Hit<float>::start());
      if (t && Hit<float>{*t, block.id[lane]}.before(nearest)) nearest = {*t, block.id[lane]};
    }
    return nearest;
  }

  const Primitives<float, Method>& primitives_;
  const Block* const blocks_;
  const Stacks& stacks_;
};

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#endif
