// Many single rays in flight. What limits one ray's way down a hierarchy is latency: which node comes next is
// known about 35 cycles after a node was begun, and guessing it by a branch fails about once a node on
// incoherent rays. So `slot_count` rays take turns, each a step at a time, without a branch that depends on a
// ray; their steps overlap in the processor, the more of them since each is done in two halves. Rays are
// sorted by what they need next (a node, a block of triangles, a hit looked at, a new ray) into lists whose
// lengths are all that branches depend on.
#if defined(RAYSWEEP_WIDE_STREAM_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYSWEEP_WIDE_STREAM_INL_H_
#undef RAYSWEEP_WIDE_STREAM_INL_H_
#else
#define RAYSWEEP_WIDE_STREAM_INL_H_
#endif

#include <utility>

#include "tracer/wide/hit_looks-inl.h"
#include "tracer/wide/ray_lists-inl.h"
#include "tracer/wide/ray_loader-inl.h"
#include "tracer/wide/two_steps-inl.h"

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

  /// Of the rays in the groups that `scratch` lists takes either the flat ones or all others.
  HWY_INLINE Stream(const Geometry& geometry, const RayBatch& rays, HitBatch& hits, KernelScratch& scratch,
                    bool takes_flat)
      : nodes_(geometry.tree.nodes.data()),
        blocks_(geometry.blocks.data()),
        hits_(hits),
        scratch_(scratch),
        count_(scratch.visits),
        takes_flat_(takes_flat),
        loader_(geometry, rays, hits, scratch, takes_flat),
        looks_(*geometry.primitives, geometry.blocks.data(), stacks_) {
    const size_t stack_size = Stacks::size_for(geometry.tree);
    constexpr size_t slot_bytes = sizeof(Slot) + sizeof(Distances);
    slots_ = static_cast<char*>(scratch.reserve(slot_count * (slot_bytes + stack_size * Stacks::entry_bytes) +
                                                RayLists::size() * sizeof(uint32_t)));
    distances_ = slots_ + slot_count * sizeof(Slot);
    lists_.place(
        reinterpret_cast<uint32_t*>(stacks_.place(slots_ + slot_count * slot_bytes, slot_count, stack_size)));
    for (uint32_t i = 0; i < slot_count; ++i) {
      const auto offset = static_cast<uint32_t>(i * sizeof(Slot));
      Slot& slot = *new (slots_ + offset) Slot;
      stacks_.begin(slot, i * stack_size);
      Stacks::restart(slot);
      lists_.empty.slots[lists_.empty.count++] = offset;
    }
  }

  HWY_INLINE void run() {
    begin_rays();
    while (lists_.next_nodes.count + lists_.leaves.count + lists_.candidates.count > 0) {
      std::swap(lists_.nodes, lists_.next_nodes);
      lists_.next_nodes.count = lists_.ended.count = 0;
      takes_flat_ ? visit_nodes<true>() : visit_nodes<false>();
      // Fewer wait for others, as long as there are nodes to visit: a loop's end takes as long as some
      // visits.
      constexpr uint32_t enough = 16;
      if (lists_.leaves.count >= enough || lists_.next_nodes.count < enough) {
        visit_leaves();
        look_at_candidates();
      }
      end_rays();
      begin_rays();
    }
    scratch_.choice(any).went_alone(cycles_, takes_flat_ ? 0 : loader_.ray_count());
  }

 private:
  HWY_INLINE Slot& slot_at(uint32_t offset) const { return *reinterpret_cast<Slot*>(slots_ + offset); }

  // Each a function of its own, with what its loop reads in locals: together they would keep it on the stack.

  /// Begins rays at the root as long as there are slots for as many as are looked at together.
  HWY_NOINLINE HWY_ATTR void begin_rays() {
    const Words dw;
    uint32_t* const empty = lists_.empty.slots;
    uint32_t left = lists_.empty.count, begun = lists_.next_nodes.count;
    while (left >= lane_count && loader_.has_next()) {
      uint32_t* const taken = empty + left - lane_count;
      const uint32_t count = loader_.load_next(slots_, taken);
      if (count == 0) continue;
      RAYSWEEP_COUNT(count_, Visited::ray_begun, count);
      hn::StoreU(hn::LoadU(dw, taken), dw, lists_.next_nodes.slots + begun);
      hn::StoreU(hn::LoadU(dw, taken + count), dw, taken);
      begun += count;
      left -= count;
    }
    lists_.next_nodes.count = begun;
    lists_.empty.count = left;
  }

  HWY_NOINLINE HWY_ATTR void end_rays() {
    const uint32_t count = lists_.ended.count;
    cycles_ += count * StepCosts::ray;
    float* const t = hits_.t.data();
    uint32_t* const id = hits_.id.data();
    for (uint32_t i = 0; i < count; ++i) {
      const uint32_t offset = lists_.ended.slots[i];
      Slot& slot = slot_at(offset);
      t[slot.ray] = slot.t;
      id[slot.ray] = slot.id;
      Stacks::restart(slot);
      lists_.empty.slots[lists_.empty.count + i] = offset;
    }
    lists_.empty.count += count;
  }

  template <bool is_flat>
  HWY_NOINLINE HWY_ATTR void visit_nodes() {
    const uint32_t count = lists_.nodes.count;
    cycles_ += count * StepCosts::ray_node;
    RAYSWEEP_COUNT(count_, Visited::ray_node, count);
    const Node* const nodes = nodes_;
    char* const slots = slots_;
    uint32_t* const now = lists_.nodes.slots;
    const Stacks stacks = stacks_;
    struct EnteredChildren {
      const char* node;
      FloatLanes enter;  // infinity where they are not met
    };
    struct MetChildren {
      WordLanes children;
      uint32_t met;  // a bit each
    };
    struct Step : std::conditional_t<any, MetChildren, EnteredChildren> {
      Slot* slot;
    };
    const auto children_of = [](const char* node) HWY_ATTR {
      return hn::Load(Words(), reinterpret_cast<const uint32_t*>(node + offsetof(Node, children)));
    };
    const auto first = [&](uint32_t i) RAYSWEEP_STEP {
      Slot& slot = *reinterpret_cast<Slot*>(slots + now[i]);
      const char* const node = reinterpret_cast<const char*>(nodes + slot.current);
      const Meeting meeting = meet_of_ray<is_flat>(slot, node);
      if constexpr (any)
        return Step{{children_of(node), bits_of(meeting.met)}, &slot};
      else
        return Step{{node, meeting.enter_if_met()}, &slot};
    };
    const auto second = [&](const Step& step, uint32_t i) RAYSWEEP_STEP {
      if constexpr (any) {
        stacks.push(*step.slot, step.children, step.met);
      } else {
        const uint32_t far_to_near = *reinterpret_cast<const uint32_t*>(step.node + step.slot->order);
        stacks.push_in_order(*step.slot, children_of(step.node), step.enter, far_to_near);
      }
      RayLists::wanted(now)[i] = step.slot->current;
    };
    in_two_steps<2>(count, first, second);
    lists_.add<false>(now, count);
  }

  HWY_NOINLINE HWY_ATTR void visit_leaves() {
    const Floats d;
    const uint32_t count = std::exchange(lists_.leaves.count, 0);
    cycles_ += count * StepCosts::ray_block;
    RAYSWEEP_COUNT(count_, Visited::ray_block, count);
    const Block* const blocks = blocks_;
    char* const slots = slots_;
    uint32_t* const leaves = lists_.leaves.slots;
    const Stacks stacks = stacks_;
    char* const distances = distances_;
    const auto first = [&](uint32_t i) RAYSWEEP_STEP {
      Slot& slot = *reinterpret_cast<Slot*>(slots + leaves[i]);
      const Block& block = blocks[child_index(slot.current)];
      RAYSWEEP_COUNT(count_, Visited::ray_test, block.count);
      const auto& axes = axes_of<Method>(slot.longest_axis);
      const auto by_axes = [&](const float* v)
                               HWY_ATTR { return broadcast(Floats(), v[axes[0]], v[axes[1]], v[axes[2]]); };
      return project(Method{}, by_axes(shears<Method> ? slot.shear : slot.direction),
                     seen_from(Method{}, by_axes(slot.origin), prepare(Method{}, corners_of(block, axes))));
    };
    const auto second = [&](const auto& projected, uint32_t i) RAYSWEEP_STEP {
      const uint32_t offset = leaves[i];
      Slot& slot = *reinterpret_cast<Slot*>(slots + offset);
      const uint32_t index = child_index(slot.current);
      const Block& block = blocks[index];
      const auto found = divide(d, projected);
      // Every lane of a block of spheres is a candidate.
      const uint32_t spheres = 0u - ((slot.current >> 30) & 1);
      const LaneMask hits = is_hit(d, found);
      const uint32_t candidates = bits_of(hits) | (spheres & ((1u << block.count) - 1));
      hn::Store(hn::IfThenElse(hits, found.t, hn::Set(d, std::numeric_limits<float>::infinity())), d,
                Distances::of(offset, distances).t);
      slot.block = index;
      stacks.leave_block(slot, block.more);
      // Not by a condition: compilers make a branch of it, which nobody can guess.
      static_assert(candidate == ~0u);
      RayLists::wanted(leaves)[i] = slot.current | (0u - static_cast<uint32_t>(candidates != 0));
    };
    in_two_steps<1>(count, first, second);
    lists_.add<true>(leaves, count);
  }

  /// What does not fill a vector waits, as long as there are rays to go on with.
  HWY_NOINLINE HWY_ATTR void look_at_candidates() {
    RayLists::List& candidates = lists_.candidates;
    uint32_t* const looked_at = lists_.looked_at.slots;
    const uint32_t left = loader_.has_next() ? candidates.count % lane_count : 0,
                   count = candidates.count - left;
    cycles_ += count * StepCosts::ray_look;
    RAYSWEEP_COUNT(count_, Visited::ray_look, count);
    for (uint32_t i = 0; i < count; i += lane_count)
      looks_.look_at(slots_, distances_, candidates.slots + i, std::min<uint32_t>(count - i, lane_count),
                     looked_at + i, RayLists::wanted(looked_at) + i);
    hn::Store(hn::LoadU(Words(), candidates.slots + count), Words(), candidates.slots);
    candidates.count = left;
    lists_.add<false>(looked_at, count);
  }

  const Node* const nodes_;
  const Block* const blocks_;
  HitBatch& hits_;
  KernelScratch& scratch_;
  char* slots_;
  char* distances_;
  Stacks stacks_;
  RayLists lists_;
  uint64_t cycles_ = 0;  // that it took so far, about
  [[no_unique_address]] const VisitCounter count_;
  const bool takes_flat_;
  RayLoader<Method, any> loader_;
  const HitLooks<Method, any> looks_;
};

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#endif
