// Where packets meet the triangles of leaves.
#if defined(RAYSWEEP_WIDE_PACKET_LEAVES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYSWEEP_WIDE_PACKET_LEAVES_INL_H_
#undef RAYSWEEP_WIDE_PACKET_LEAVES_INL_H_
#else
#define RAYSWEEP_WIDE_PACKET_LEAVES_INL_H_
#endif

#include <new>
#include <utility>

#include "tracer/wide/nearest-inl.h"
#include "tracer/wide/packet-inl.h"
#include "tracer/wide/spread_rays-inl.h"
#include "tracer/wide/two_steps-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raysweep {
namespace HWY_NAMESPACE {

/// Blocks that packets visit in one round. Where many of a packet's rays meet a leaf, each triangle meets all
/// rays at once, a ray a lane; where few do, each of them meets all triangles, a triangle a lane.
template <class Method, bool any>
class PacketLeaves {
  /// Of one round's tests, with room for what stores at once: a vector of lanes, and a test's rays.
  static constexpr size_t list_size = packets_in_flight * packet_size + lane_count,
                          distance_count = (packets_in_flight * packet_size + rays_a_test) * lane_count;

 public:
  using Geometry = WideGeometry<Method, lane_count>;
  using Block = typename Geometry::Block;

  HWY_INLINE PacketLeaves(const Geometry& geometry, KernelScratch& scratch)
      : primitives_(*geometry.primitives), blocks_(geometry.blocks.data()), count_(scratch.visits) {}

  static constexpr size_t bytes = packets_in_flight * sizeof(BlockRows) + distance_count * sizeof(float) +
                                  2 * list_size * sizeof(uint32_t);

  /// Works on `packets` in `memory`, which has room for `bytes` and begins a cache line; where it ends.
  HWY_INLINE char* place(char* memory, char* packets) {
    packets_ = packets;
    rows_ = new (memory) BlockRows[packets_in_flight];
    distances_ = reinterpret_cast<float*>(rows_ + packets_in_flight);
    tests_ = reinterpret_cast<uint32_t*>(distances_ + distance_count);
    candidates_ = tests_ + list_size;
    return reinterpret_cast<char*>(candidates_ + list_size);
  }

  /// All rays of the packets at `offsets` meet the block that each visits. `have_one_origin`: whether those
  /// of each packet do.
  HWY_INLINE void meet_together(const uint32_t* offsets, uint32_t count, bool have_one_origin) {
    have_one_origin ? meet_together<true>(offsets, count) : meet_together<false>(offsets, count);
  }

  /// Those rays of the packets that meet the leaf's box do.
  HWY_NOINLINE HWY_ATTR void meet_apart(const uint32_t* offsets, uint32_t count) {
    uint32_t rays = 0;
    for (uint32_t i = 0; i < count; ++i) rays += list_rays(offsets[i], tests_ + rays);
    const uint32_t candidates = test_apart(rays);
    for (uint32_t i = 0; i < candidates; ++i) look_at_ray(candidates_[i], distances_ + i * lane_count);
  }

 private:
  HWY_INLINE Packet& packet_at(uint32_t offset) const {
    return *reinterpret_cast<Packet*>(packets_ + offset);
  }

  template <bool have_one_origin>
  HWY_NOINLINE HWY_ATTR void meet_together(const uint32_t* offsets, uint32_t count) {
    uint32_t tests = 0;
    for (uint32_t i = 0; i < count; ++i)
      tests += list_triangles<have_one_origin>(offsets[i], i, tests_ + tests);
    const uint32_t candidates = test_together<have_one_origin>(offsets, tests);
    for (uint32_t i = 0; i < candidates; ++i)
      look_at(offsets[candidates_[i] / lane_count], candidates_[i], distances_ + i * packet_size);
  }

  /// Lists the triangles of the block that some ray may meet, as lanes of rows number `visit`; how many.
  template <bool has_one_origin>
  HWY_INLINE uint32_t list_triangles(uint32_t offset, uint32_t visit, uint32_t* list) {
    const Floats d;
    const Words dw;
    Packet& packet = packet_at(offset);
    const Block& block = blocks_[packet.block];
    RAYSWEEP_COUNT(count_, Visited::packet_block);
    if ((packet.child & sphere_bit) != 0) {
      RAYSWEEP_COUNT(count_, Visited::packet_test, block.count);
      for (uint32_t lane = 0; lane < block.count; ++lane)
        meet_sphere<any>(primitives_, packet, block.id[lane]);
      return 0;
    }
    BlockRows& rows = rows_[visit];
    rows.set_boxes(boxes_of(d, corners_of(block)));
    const auto& axes = axes_of<Method>(packet.longest_axis);
    const auto prepared = prepare(Method{}, corners_of(block, axes));
    if constexpr (has_one_origin) {
      const auto& from = packet.origin;
      const auto origin = broadcast(d, from[axes[0]][0], from[axes[1]][0], from[axes[2]][0]);
      rows.set_vectors(seen_from(Method{}, origin, prepared));
    } else {
      rows.set_vectors(prepared);
    }
    const auto meeting = packet.beam.meet(
        [&rows](size_t at) HWY_ATTR { return hn::Load(Floats(), rows.box_row(at / row_bytes)); });
    const LaneMask is_there = hn::RebindMask(d, hn::Lt(hn::Iota(dw, 0), hn::Set(dw, block.count)));
    const Compaction kept(hn::And(meeting.met, is_there));
    hn::StoreU(kept(count_from(visit * lane_count)), dw, list);
    return kept.count();
  }

  template <bool have_one_origin>
  HWY_NOINLINE HWY_ATTR uint32_t test_together(const uint32_t* offsets, uint32_t count) {
    constexpr uint32_t parts = packet_size / rays_at_once;
    uint32_t met = 0, is_met = 0;
    const auto first = [&](uint32_t i) RAYSWEEP_STEP {
      const uint32_t test = tests_[i / parts];
      const Packet& packet = packet_at(offsets[test / lane_count]);
      const BlockRows& rows = rows_[test / lane_count];
      return project_rays<Method, have_one_origin>(packet, i % parts * rays_at_once, rows, test % lane_count);
    };
    const auto second = [&](const auto& projected, uint32_t i) RAYSWEEP_STEP {
      const RayTag d;
      const auto found = divide(d, projected);
      const RayMask hit = is_hit(d, found);
      hn::Store(hn::IfThenElse(hit, found.t, hn::Set(d, std::numeric_limits<float>::infinity())), d,
                distances_ + met * packet_size + i % parts * rays_at_once);
      is_met |= hn::AllFalse(d, hit) ? 0 : 1;
      if (i % parts != parts - 1) return;
      RAYSWEEP_COUNT(count_, Visited::packet_test);
      candidates_[met] = tests_[i / parts];
      met += std::exchange(is_met, 0);
    };
    in_two_steps<2>(count * parts, first, second);
    return met;
  }

  HWY_INLINE void look_at(uint32_t offset, uint32_t test, const float* distances) {
    const RayTag d;
    const size_t lane = test % lane_count;
    Packet& packet = packet_at(offset);
    const Block& block = blocks_[packet.block];
    const Corners<RayTag> corners{spread(block.corners, lane), spread(block.corners + 3, lane),
                                  spread(block.corners + 6, lane)};
    const Lanes3<RayTag> normal = spread(block.normal, lane);
    RAYSWEEP_COUNT(count_, Visited::packet_look);
    const LaneBoxes<RayTag> boxes = rows_[test / lane_count].box(lane);
    uint32_t undecided = 0;
    for (size_t at = 0; at < packet_size; at += rays_at_once) {
      const RayLanes t = hn::Load(d, distances + at);
      const AcceptedHits<RayTag> hits =
          accept(Method{}, d, load_rays(packet.origin, at), load_rays(packet.direction, at),
                 load_rays(packet.reciprocal, at), boxes, corners, normal, t);
      const RayMask is_candidate = hn::Lt(t, hn::Set(d, std::numeric_limits<float>::infinity()));
      keep<any>(packet, at, hits.t, hn::And(is_candidate, hits.accepted), block.id[lane]);
      if constexpr (Method::is_watertight) undecided |= bits_of(hn::IsNaN(t)) << at;
    }
    for (; undecided != 0; undecided &= undecided - 1)
      decide(packet, hwy::Num0BitsBelowLS1Bit_Nonzero32(undecided), block.id[lane]);
  }

  /// Whether ray `i` meets a triangle of which lanes cannot tell.
  HWY_NOINLINE HWY_ATTR void decide(Packet& packet, size_t i, uint32_t id) {
    const OneRay ray = ray_of<Method>(packet, i);
    const auto t = primitives_.accept_triangle(id, std::numeric_limits<float>::quiet_NaN(), ray.ray(),
                                               ray.slab_ray(), Hit<float>::start());
    if (t) keep_of_ray<any>(packet, i, {*t, id});
  }

  /// Lists the rays that meet the leaf's box, as their packet's offset plus their number; how many.
  HWY_INLINE uint32_t list_rays(uint32_t offset, uint32_t* list) {
    const Packet& packet = packet_at(offset);
    uint32_t count = 0;
    for (uint32_t at = 0; at < packet_size; at += lane_count) {
      const Compaction kept(mask_of(packet.active >> at));
      hn::StoreU(kept(count_from(offset + at)), Words(), list + count);
      count += kept.count();
    }
    RAYSWEEP_COUNT(count_, Visited::packet_block_apart);
    RAYSWEEP_COUNT(count_, Visited::packet_ray, count);
    if constexpr (rays_a_test == 2) {
      list[count] = list[count - 1];  // once more where one is left over
      count += count & 1;
    }
    return count;
  }

  HWY_NOINLINE HWY_ATTR uint32_t test_apart(uint32_t count) {
    uint32_t met = 0;
    const auto first = [&](uint32_t i) RAYSWEEP_STEP {
      const uint32_t* const rays = tests_ + i * rays_a_test;
      const Packet& packet = packet_at(rays[0] & ~uint32_t{packet_size - 1});
      return project_apart(packet, blocks_[packet.block], SpreadRays(rays));
    };
    const auto second = [&](const auto& projected, uint32_t i) RAYSWEEP_STEP {
      const SpreadRays::Tag d;
      const auto found = divide(d, projected);
      const auto hit = is_hit(d, found);
      const auto t = hn::IfThenElse(hit, found.t, hn::Set(d, std::numeric_limits<float>::infinity()));
      met += SpreadRays::list(tests_ + i * rays_a_test, hit, t, candidates_ + met,
                              distances_ + met * lane_count);
    };
    in_two_steps<1>(count / rays_a_test, first, second);
    return met;
  }

  /// Some rays of a packet and the triangles of a block.
  HWY_INLINE static auto project_apart(const Packet& packet, const Block& block, const SpreadRays& rays) {
    static constexpr uint32_t in_order[3] = {0, 1, 2};
    const auto& axes = axes_of<Method>(packet.longest_axis);
    auto seen = seen_from(Method{}, rays.of(packet.origin, axes),
                          prepare(Method{}, SpreadRays::corners_of(block, axes)));
    if constexpr (shears<Method>) {
      if (packet.has_one_axis == 0) seen = AxisSwap<SpreadRays::Tag>(rays.of(packet.axes))(seen);
      return project(Method{}, rays.of(packet.shear, in_order), seen);
    } else {
      return project(Method{}, rays.of(packet.direction, in_order), seen);
    }
  }

  HWY_INLINE void look_at_ray(uint32_t word, const float* distances) {
    const size_t i = word % packet_size;
    Packet& packet = packet_at(word - static_cast<uint32_t>(i));
    RAYSWEEP_COUNT(count_, Visited::packet_ray_look);
    keep_of_ray<any>(
        packet, i,
        nearest_triangle(primitives_, blocks_[packet.block], ray_of<Method>(packet, i), distances));
  }

  const Primitives<float, Method>& primitives_;
  const Block* const blocks_;
  [[no_unique_address]] const VisitCounter count_;
  char* packets_ = nullptr;
  BlockRows* rows_ = nullptr;       // of each visit together
  float* distances_ = nullptr;      // of candidates: of all rays, or to all triangles
  uint32_t* tests_ = nullptr;       // visits' triangles, or packets' rays
  uint32_t* candidates_ = nullptr;  // those of them that a method says are hit
};

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#endif
