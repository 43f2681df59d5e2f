// Packets in flight, sorted by what they need next.
#if defined(RAYSWEEP_WIDE_PACKET_LISTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYSWEEP_WIDE_PACKET_LISTS_INL_H_
#undef RAYSWEEP_WIDE_PACKET_LISTS_INL_H_
#else
#define RAYSWEEP_WIDE_PACKET_LISTS_INL_H_
#endif

#include <utility>

#include "tracer/wide/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raysweep {
namespace HWY_NAMESPACE {

/// Packets by what they need next, each named by its offset in memory.
class PacketLists {
 public:
  enum Kind : uint32_t {
    popped,  // has gone on to something
    ended,
    node_of_many,  // children compared with all rays as a beam
    node_of_few,   // with each of two rays at most
    leaf_of_many,  // triangles compared with all rays
    leaf_of_few,   // with each of some rays
    kind_count
  };

  /// Numbers in the memory of all, with room for a vector of lanes stored at each list's end.
  static constexpr size_t list_size = packets_in_flight + lane_count, size = (kind_count + 2) * list_size;

  HWY_INLINE void place(uint32_t* memory) {
    for (uint32_t*& list : lists_) {
      list = memory;
      memory += list_size;
    }
    spare_ = memory;
    kinds_ = memory + list_size;
  }

  [[nodiscard]] HWY_INLINE uint32_t count(Kind kind) const { return counts_[kind]; }
  [[nodiscard]] HWY_INLINE const uint32_t* packets(Kind kind) const { return lists_[kind]; }

  struct Taken {
    const uint32_t* packets;
    uint32_t count;
  };
  /// Empties a list. What it held lasts until the next one is taken.
  HWY_INLINE Taken take(Kind kind) {
    std::swap(spare_, lists_[kind]);
    return {spare_, std::exchange(counts_[kind], 0)};
  }

  HWY_INLINE void add(Kind kind, uint32_t packet) { lists_[kind][counts_[kind]++] = packet; }

  /// Of packets to be sorted, in their order.
  [[nodiscard]] HWY_INLINE uint32_t* kinds() const { return kinds_; }
  /// Adds packets just taken to the lists of `kinds()`, which are among `these`.
  template <size_t count>
  HWY_INLINE void sort(const Taken& taken, const Kind (&these)[count]) {
    const Floats d;
    const Words dw;
    for (uint32_t i = 0; i < taken.count; i += lane_count) {
      const WordLanes packets = hn::Load(dw, taken.packets + i), kinds = hn::Load(dw, kinds_ + i);
      const LaneMask is_there = hn::RebindMask(d, hn::Lt(count_from(i), hn::Set(dw, taken.count)));
      for (const Kind kind : these) {
        const Compaction kept(hn::And(hn::RebindMask(d, hn::Eq(kinds, hn::Set(dw, kind))), is_there));
        hn::StoreU(kept(packets), dw, lists_[kind] + counts_[kind]);
        counts_[kind] += kept.count();
      }
    }
  }
  HWY_INLINE void add(Kind kind, const Taken& taken) {
    for (uint32_t i = 0; i < taken.count; i += lane_count)
      hn::StoreU(hn::Load(Words(), taken.packets + i), Words(), lists_[kind] + counts_[kind] + i);
    counts_[kind] += taken.count;
  }

  [[nodiscard]] HWY_INLINE bool is_any_left() const {
    uint32_t count = 0;
    for (const uint32_t of_kind : counts_) count += of_kind;
    return count > 0;
  }

 private:
  uint32_t* lists_[kind_count] = {};
  uint32_t counts_[kind_count] = {};
  uint32_t *spare_ = nullptr, *kinds_ = nullptr;
};

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#endif
