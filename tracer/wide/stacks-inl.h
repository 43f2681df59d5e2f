// Stacks of what is left to visit, one for each ray or packet in flight.
#if defined(RAYSWEEP_WIDE_STACKS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYSWEEP_WIDE_STACKS_INL_H_
#undef RAYSWEEP_WIDE_STACKS_INL_H_
#else
#define RAYSWEEP_WIDE_STACKS_INL_H_
#endif

#include "tracer/wide/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raysweep {
namespace HWY_NAMESPACE {

/// Boxes that a ray, or one of several, may be inside of, and where the first one enters.
struct Meeting {
  FloatLanes enter;
  LaneMask met;

  /// Infinity for those that none is.
  [[nodiscard]] HWY_INLINE FloatLanes enter_if_met() const {
    return hn::IfThenElse(met, enter, hn::Set(Floats(), std::numeric_limits<float>::infinity()));
  }
};

inline constexpr WideChild sentinel = leaf_bit;  // the block without primitives: the end of a stack

/// What is in flight knows where its stack is, from `bottom` to before `top`, what was popped last, and which
/// block of a leaf was visited last.
struct StackPlace {
  uint32_t top, bottom;
  WideChild current;
  uint32_t block;
};

class Stacks {
 public:
  /// Entries that one stack may need, and a vector's store at its top or one read at its end reach past.
  /// Stacks begin cache lines, so that most of them never leave their first ones; of an odd number each,
  /// which spreads them.
  template <class Tree>
  HWY_INLINE static size_t size_for(const Tree& tree) {
    constexpr size_t line = 64 / sizeof(WideChild);
    return ((tree.stack_size() + 3 * lane_count + line - 1) / line | 1) * line;
  }
  static constexpr size_t entry_bytes = sizeof(WideChild) + sizeof(float);

  /// `count` stacks of `size` entries in `memory`; where it ends.
  HWY_INLINE char* place(char* memory, size_t count, size_t size) {
    children_ = reinterpret_cast<WideChild*>(memory);
    enters_ = reinterpret_cast<float*>(children_ + count * size);
    return reinterpret_cast<char*>(enters_ + count * size);
  }

  HWY_INLINE void begin(StackPlace& at, size_t bottom) const {
    at.bottom = static_cast<uint32_t>(bottom);
    children_[bottom] = sentinel;
    enters_[bottom] = -1;  // never cut off
  }

  /// Starts over at the root.
  HWY_INLINE static void restart(StackPlace& at) {
    at.top = at.bottom + 1;
    at.current = 0;
  }

  /// Pushes the children that are entered somewhere, at `enter` or, where it is infinity, nowhere, from far
  /// to near, and pops the nearest, else what was left for later.
  HWY_INLINE void push_in_order(StackPlace& at, WordLanes children, FloatLanes enter,
                                uint32_t far_to_near) const {
    const Floats d;
    const Words dw;
    const WordLanes by_distance = unpack(far_to_near);
    const FloatLanes keys = permute(enter, by_distance);
    const Compaction kept(hn::Lt(keys, hn::Set(d, std::numeric_limits<float>::infinity())));
    const uint32_t top = at.top;
    hn::StoreU(kept(permute(children, by_distance)), dw, children_ + top);
    hn::StoreU(kept(keys), d, enters_ + top);
    pop(at, top + kept.count());
  }

  /// Pushes children that are met, a bit each, in any order.
  HWY_INLINE void push(StackPlace& at, WordLanes children, uint32_t met) const {
    const Compaction kept(met);
    const uint32_t top = at.top;
    hn::StoreU(kept(children), Words(), children_ + top);
    pop(at, top + kept.count());
  }

  /// Goes on to the leaf's next block, else to what the stack holds.
  HWY_INLINE void leave_block(StackPlace& at, uint32_t more) const {
    const uint32_t top = at.top - (1 - more);
    const WideChild popped = children_[top];
    at.current = more != 0 ? at.current + 1 : popped;
    at.top = top;
  }

  /// Forgets what begins behind `limit`.
  HWY_INLINE void shorten(StackPlace& at, float limit) const { shorten(at, at.top, limit); }

  /// The same just after a block was left, which went on to its leaf's next one if there was `more`.
  HWY_INLINE void shorten_after_block(StackPlace& at, float limit, uint32_t more) const {
    // What was popped for `current` is still there; only a leaf that goes on was not.
    shorten(at, at.top + (1 - more), limit);
    const uint32_t top = at.top - (1 - more);
    const WideChild popped = children_[top];
    at.current = more != 0 ? at.current : popped;
    at.top = top;
  }

  HWY_INLINE void pop(StackPlace& at) const { pop(at, at.top); }

 private:
  /// Keeps what begins before `limit_now` of the entries before `end`, 16 at a time where vectors are as
  /// wide, elsewhere two vectors.
  HWY_INLINE void shorten(StackPlace& at, uint32_t end, float limit_now) const {
    constexpr uint32_t at_once = lanes_compacted;
    using D = hn::FixedTag<float, at_once>;
    using DW = hn::FixedTag<uint32_t, at_once>;
    const hn::Vec<D> limit = hn::Set(D(), limit_now);
    const hn::Vec<DW> ends = hn::Set(DW(), end);
    uint32_t kept = at.bottom;
    const auto keep = [&](const hn::Vec<D>& enters, const hn::Vec<DW>& children, uint32_t from) HWY_ATTR {
      const auto is_entry = hn::RebindMask(D(), hn::Lt(count_from(DW(), from), ends));
      const CompactionOf<D> stay(hn::And(hn::Le(enters, limit), is_entry));
      hn::StoreU(stay(enters), D(), enters_ + kept);
      hn::StoreU(stay(children), DW(), children_ + kept);
      kept += stay.count();
    };
    uint32_t from = at.bottom;
    do {
      const hn::Vec<D> enters = hn::LoadU(D(), enters_ + from);
      const hn::Vec<DW> children = hn::LoadU(DW(), children_ + from);
      if constexpr (at_once == 2 * lane_count) {
        keep(enters, children, from);
      } else {
        const hn::Vec<D> more = hn::LoadU(D(), enters_ + from + lane_count);
        const hn::Vec<DW> others = hn::LoadU(DW(), children_ + from + lane_count);
        keep(enters, children, from);
        keep(more, others, from + lane_count);
      }
      from += 2 * lane_count;
    } while (from < end);
    at.top = kept;
  }

  HWY_INLINE void pop(StackPlace& at, uint32_t top) const {
    --top;
    at.current = children_[top];
    at.top = top;
  }

  WideChild* children_ = nullptr;
  float* enters_ = nullptr;
};

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#endif
