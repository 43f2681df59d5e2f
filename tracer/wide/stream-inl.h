// Many single rays in flight. What limits one ray's way down a hierarchy is latency: which node comes next is
// known about 35 cycles after a node was begun, and guessing it by a branch fails about once a node on
// incoherent rays. So `slot_count` rays take turns, each a step at a time, without a branch that depends on a
// ray; their steps overlap in the processor. Rays are sorted by what they need next (a node, a block of
// triangles, a hit looked at, a new ray) into lists whose lengths are all that branches depend on.
#if defined(RAYSWEEP_WIDE_STREAM_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYSWEEP_WIDE_STREAM_INL_H_
#undef RAYSWEEP_WIDE_STREAM_INL_H_
#else
#define RAYSWEEP_WIDE_STREAM_INL_H_
#endif

#include <utility>

#include "tracer/wide/nearest-inl.h"
#include "tracer/wide/ray_lists-inl.h"
#include "tracer/wide/ray_setup-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raysweep {
namespace HWY_NAMESPACE {

template <class Method, bool any>
class Stream {
 public:
  using Geometry = WideGeometry<Method, lane_count>;
  using Node = WideNode<lane_count>;
  using Block = typename Geometry::Block;
  static_assert(sizeof(WideNode<8>) == 256 && offsetof(WideNode<8>, children) == 192);

  HWY_INLINE Stream(const Geometry& geometry, const RayBatch& rays, HitBatch& hits, KernelScratch& scratch)
      : primitives_(*geometry.primitives),
        nodes_(geometry.tree.nodes.data()),
        blocks_(geometry.blocks.data()),
        hits_(hits),
        scratch_(scratch),
        count_(scratch.visits),
        chooser_(rays, hits, geometry.tree.bounds, scratch) {
    const size_t stack_size = Stacks::size_for(geometry.tree);
    slots_ = static_cast<char*>(
        scratch.reserve(slot_count * (sizeof(Slot) + stack_size * Stacks::entry_bytes) +
                        (RayLists::size + chosen_at_once + 2 * packet_size) * sizeof(uint32_t)));
    auto* memory = reinterpret_cast<uint32_t*>(
        stacks_.place(slots_ + slot_count * sizeof(Slot), slot_count, stack_size));
    chooser_.work_in(lists_.place(memory));
    for (uint32_t i = 0; i < slot_count; ++i)
      stacks_.begin(*new (slots_ + i * sizeof(Slot)) Slot, i * stack_size);
  }

  HWY_INLINE void run() {
    for (uint32_t i = 0; i < slot_count && chooser_.has_next(); ++i)
      begin(static_cast<uint32_t>(i * sizeof(Slot)));
    while (lists_.next_nodes.count + lists_.leaves.count > 0) {
      std::swap(lists_.nodes, lists_.next_nodes);
      lists_.next_nodes.count = lists_.candidates.count = lists_.ended.count = 0;
      visit_nodes();
      visit_leaves();
      look_at_candidates();
      cycles_ += lists_.ended.count * StepCosts::ray;
      for (uint32_t i = 0; i < lists_.ended.count; ++i) end(lists_.ended.slots[i]);
    }
    scratch_.choice(any).went_alone(cycles_, chooser_.ray_count());
  }

 private:
  HWY_INLINE Slot& slot_at(uint32_t offset) const { return *reinterpret_cast<Slot*>(slots_ + offset); }

  /// Begins the next ray at the root.
  HWY_INLINE void begin(uint32_t offset) {
    Slot& slot = slot_at(offset);
    chooser_.load_next(slot);
    if constexpr (shears<Method>) slot.set_shear();
    Stacks::restart(slot);
    RAYSWEEP_COUNT(count_, Visited::ray_begun);
    lists_.next_nodes.slots[lists_.next_nodes.count++] = offset;
  }

  // Each a function of its own, with what its loop reads in locals: together they would keep it on the stack.

  HWY_NOINLINE HWY_ATTR void visit_nodes() {
    const uint32_t count = lists_.nodes.count;
    cycles_ += count * StepCosts::ray_node;
    RAYSWEEP_COUNT(count_, Visited::ray_node, count);
    const Floats d;
    const Words dw;
    const FloatLanes wider = hn::Set(d, widening);
    constexpr size_t row = lane_count * sizeof(float);
    const Node* const nodes = nodes_;
    char* const slots = slots_;
    const uint32_t* const now = lists_.nodes.slots;
    uint32_t* const wanted = lists_.wanted;
    const Stacks stacks = stacks_;
    for (size_t i = 0; i < count; ++i) {
      Slot& slot = *reinterpret_cast<Slot*>(slots + now[i]);
      const char* const node = reinterpret_cast<const char*>(nodes + slot.current);
      const auto plane = [node](size_t at) HWY_ATTR {
        return hn::Load(Floats(), reinterpret_cast<const float*>(node + at));
      };
      const auto meet = [&](size_t at, int axis, const float* offsets) HWY_ATTR {
        return hn::MulAdd(plane(at), hn::Set(Floats(), slot.reciprocal[axis]),
                          hn::Set(Floats(), offsets[axis]));
      };
      const size_t x = slot.near_plane[0], y = slot.near_plane[1], z = slot.near_plane[2];
      const FloatLanes enter = hn::Max(hn::Max(meet(x, 0, slot.near_offset), meet(y, 1, slot.near_offset)),
                                       hn::Max(meet(z, 2, slot.near_offset), hn::Zero(d)));
      // Rows of lower and upper planes take turns: the far one's place differs by one bit.
      const FloatLanes leave =
          hn::Min(meet(x ^ row, 0, slot.far_offset),
                  hn::Min(meet(y ^ row, 1, slot.far_offset), meet(z ^ row, 2, slot.far_offset)));
      const LaneMask met = hn::Le(enter, hn::Min(hn::Mul(leave, wider), hn::Set(d, slot.limit)));
      const WordLanes children =
          hn::Load(dw, reinterpret_cast<const uint32_t*>(node + offsetof(Node, children)));
      if constexpr (any) {
        stacks.push(slot, children, met);
      } else {
        const uint32_t far_to_near = *reinterpret_cast<const uint32_t*>(node + slot.near_plane[3]);
        stacks.push_in_order(slot, children, enter, met, far_to_near);
      }
      wanted[i] = slot.current;
    }
    lists_.add(now, count);
  }

  HWY_NOINLINE HWY_ATTR void visit_leaves() {
    const Floats d;
    const uint32_t count = std::exchange(lists_.leaves.count, 0);
    cycles_ += count * StepCosts::ray_block;
    RAYSWEEP_COUNT(count_, Visited::ray_block, count);
    const Block* const blocks = blocks_;
    char* const slots = slots_;
    const uint32_t* const leaves = lists_.leaves.slots;
    uint32_t* const wanted = lists_.wanted;
    const Stacks stacks = stacks_;
    for (size_t i = 0; i < count; ++i) {
      Slot& slot = *reinterpret_cast<Slot*>(slots + leaves[i]);
      const uint32_t index = child_index(slot.current);
      const Block& block = blocks[index];
      RAYSWEEP_COUNT(count_, Visited::ray_test, block.count);
      const auto& axes = axes_of<Method>(slot.longest_axis);
      const auto by_axes = [&](const float* v)
                               HWY_ATTR { return broadcast(Floats(), v[axes[0]], v[axes[1]], v[axes[2]]); };
      const auto found =
          solve(Method{}, d, by_axes(shears<Method> ? slot.shear : slot.direction),
                seen_from(Method{}, by_axes(slot.origin), prepare(Method{}, corners_of(block, axes))));
      // Every lane of a block of spheres is a candidate.
      const uint32_t spheres = 0u - ((slot.current >> 30) & 1);
      const LaneMask hits = is_hit(d, found);
      const uint32_t candidates = bits_of(hits) | (spheres & ((1u << block.count) - 1));
      hn::Store(hn::IfThenElse(hits, found.t, hn::Set(d, std::numeric_limits<float>::infinity())), d,
                slot.distances);
      slot.block = index;
      stacks.leave_block(slot, block.more);
      wanted[i] = candidates != 0 ? candidate : slot.current;
    }
    lists_.add(leaves, count);
  }

  HWY_NOINLINE HWY_ATTR void look_at_candidates() {
    const uint32_t count = std::exchange(lists_.candidates.count, 0);
    cycles_ += count * StepCosts::ray_look;
    for (uint32_t i = 0; i < count; ++i) lists_.wanted[i] = look_at(lists_.candidates.slots[i]);
    lists_.add(lists_.candidates.slots, count);
  }

  /// What the ray needs next.
  HWY_INLINE WideChild look_at(uint32_t offset) {
    RAYSWEEP_COUNT(count_, Visited::ray_look);
    Slot& slot = slot_at(offset);
    const Block& block = blocks_[slot.block];
    const Hit<float> hit = block.id[0] < primitives_.first_triangle() ? nearest_sphere(slot, block)
                                                                      : nearest_of_block(slot, block);
    if (any ? hit.t < slot.t : hit.before({slot.t, slot.id})) {
      slot.t = hit.t;
      slot.id = hit.id;
      if constexpr (any) {
        slot.current = sentinel;
      } else {
        slot.limit = slot.t * widening;
        stacks_.shorten_after_block(slot, slot.limit, block.more);
      }
    }
    return slot.current;
  }

  /// The first hit of the block's candidates.
  HWY_INLINE Hit<float> nearest_of_block(const Slot& slot, const Block& block) const {
    if (slot.is_flat != 0) return nearest_of_flat(slot, block);
    const auto of = [](const float* v) { return Vec3f(v[0], v[1], v[2]); };
    return nearest_triangle(primitives_, block,
                            RayNumbers{of(slot.origin), of(slot.direction), of(slot.reciprocal)},
                            slot.distances);
  }

  /// The same of a flat ray.
  HWY_INLINE Hit<float> nearest_of_flat(const Slot& slot, const Block& block) const {
    const FloatLanes infinity = hn::Set(Floats(), std::numeric_limits<float>::infinity());
    const LaneMask is_miss = hn::Eq(hn::Load(Floats(), slot.distances), infinity);
    const RayOfSlot ray(slot);
    return nearest_one_by_one(primitives_, block, ray.ray, ray.slab_ray, slot.distances, hn::Not(is_miss),
                              Hit<float>::none());
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

  HWY_INLINE void end(uint32_t offset) {
    const Slot& slot = slot_at(offset);
    hits_.t[slot.ray] = slot.t;
    hits_.id[slot.ray] = slot.id;
    if (chooser_.has_next()) begin(offset);
  }

  const Primitives<float, Method>& primitives_;
  const Node* const nodes_;
  const Block* const blocks_;
  HitBatch& hits_;
  KernelScratch& scratch_;
  char* slots_;
  Stacks stacks_;
  RayLists lists_;
  uint64_t cycles_ = 0;  // that it took so far, about
  [[no_unique_address]] const VisitCounter count_;
  Chooser<any> chooser_;
};

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#endif
