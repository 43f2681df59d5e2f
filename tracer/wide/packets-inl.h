// Packets of neighbouring rays that go the same way down a hierarchy. A node's boxes are compared with
// intervals that hold every ray of a packet (Boulos, Wald & Shirley 2006, "Geometric and arithmetic culling
// methods for entire ray packets"), so that a node costs a packet little more than a ray; so are the boxes of
// a leaf's triangles, and each triangle that is left meets all rays at once, in lanes. As in Stream, several
// take turns, without a branch that depends on a ray. A packet whose rays part costs more than they would
// alone, so it has a budget, and where packets do not pay rays go alone for a while.
#if defined(RAYSWEEP_WIDE_PACKETS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYSWEEP_WIDE_PACKETS_INL_H_
#undef RAYSWEEP_WIDE_PACKETS_INL_H_
#else
#define RAYSWEEP_WIDE_PACKETS_INL_H_
#endif

#include <utility>

#include "tracer/wide/packet-inl.h"
#include "tracer/wide/packet_loader-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raysweep {
namespace HWY_NAMESPACE {

/// As many as keep what they hold in the first cache.
inline constexpr uint32_t packets_in_flight = 8;

template <class Method, bool any>
class Packets {
 public:
  using Geometry = WideGeometry<Method, lane_count>;
  using Node = WideNode<lane_count>;
  using Block = typename Geometry::Block;

  HWY_INLINE Packets(const Geometry& geometry, const RayBatch& rays, HitBatch& hits, KernelScratch& scratch)
      : primitives_(*geometry.primitives),
        nodes_(geometry.tree.nodes.data()),
        blocks_(geometry.blocks.data()),
        hits_(hits),
        ray_count_(rays.size),
        alone_(scratch.groups),
        count_(scratch.visits),
        loader_(rays, hits, geometry.tree.bounds),
        choice_(scratch.choice(any)) {
    const size_t stack_size = Stacks::size_for(geometry.tree);
    packets_ = static_cast<char*>(
        scratch.reserve(packets_in_flight * (sizeof(Packet) + stack_size * Stacks::entry_bytes) +
                        test_count * sizeof(float[packet_size]) +
                        (4 * packets_in_flight + 2 * test_count + lane_count) * sizeof(uint32_t)));
    distances_ = reinterpret_cast<float(*)[packet_size]>(
        stacks_.place(packets_ + packets_in_flight * sizeof(Packet), packets_in_flight, stack_size));
    auto* lists = reinterpret_cast<uint32_t*>(distances_ + test_count);
    for (uint32_t** list : {&nodes_next_, &nodes_now_, &leaves_next_, &leaves_now_}) {
      *list = lists;
      lists += packets_in_flight;
    }
    candidates_ = lists;
    tests_ = lists + test_count;
    for (uint32_t i = 0; i < packets_in_flight; ++i)
      stacks_.begin(*new (packets_ + i * sizeof(Packet)) Packet, i * stack_size);
  }

  /// Lists the groups whose rays have to go alone.
  HWY_INLINE void run() {
    for (uint32_t i = 0; i < packets_in_flight; ++i) begin_next(static_cast<uint32_t>(i * sizeof(Packet)));
    while (next_node_count_ + next_leaf_count_ > 0) {
      std::swap(nodes_now_, nodes_next_);
      std::swap(leaves_now_, leaves_next_);
      const uint32_t node_count = std::exchange(next_node_count_, 0),
                     leaf_count = std::exchange(next_leaf_count_, 0);
      for (uint32_t i = 0; i < node_count; ++i) visit_node(nodes_now_[i]);
      uint32_t tests = 0, candidates = 0;
      for (uint32_t i = 0; i < leaf_count; ++i) tests += visit_block(leaves_now_[i], tests_ + tests);
      for (uint32_t i = 0; i < tests; ++i) candidates += test(tests_[i], candidates);
      for (uint32_t i = 0; i < candidates; ++i) look_at(candidates_[i], distances_[i]);
      for (uint32_t i = 0; i < leaf_count; ++i) leave_block(leaves_now_[i]);
    }
    if (next_ < ray_count_) alone_.push_back(static_cast<uint32_t>(next_));
  }

 private:
  static_assert(sizeof(Packet) % lane_count == 0 && batch_lanes % packet_size == 0);
  static constexpr size_t test_count = packets_in_flight * lane_count;

  HWY_INLINE Packet& packet_at(uint32_t offset) const {
    return *reinterpret_cast<Packet*>(packets_ + offset);
  }

  /// A packet's offset with a lane's number in its lowest bits.
  struct Test {
    uint32_t offset;
    size_t lane;
  };
  HWY_INLINE static Test test_of(uint32_t word) {
    constexpr uint32_t low = lane_count - 1;
    return {word & ~low, word & low};
  }

  HWY_INLINE void enlist(uint32_t offset) {
    const WideChild next = packet_at(offset).current;
    const uint32_t is_leaf = next >> 31;
    nodes_next_[next_node_count_] = offset;
    next_node_count_ += 1 - is_leaf;
    leaves_next_[next_leaf_count_] = offset;
    next_leaf_count_ += is_leaf;
  }

  HWY_INLINE void go_on(uint32_t offset) {
    const Packet& packet = packet_at(offset);
    if (packet.current != sentinel && packet.budget >= 0) return enlist(offset);
    save(packet);
    const int32_t steps = GroupChoice::budget - packet.budget;
    if (packet.current == sentinel) {
      choice_.ended(steps);
    } else {
      choice_.gave_up(steps);
      alone_.push_back(packet.first);
      RAYSWEEP_COUNT(count_, Visited::packet_given_up);
    }
    begin_next(offset);
  }

  HWY_INLINE void begin_next(uint32_t offset) {
    Packet& packet = packet_at(offset);
    while (next_ + packet_size <= ray_count_) {
      const size_t first = next_;
      next_ += packet_size;
      if (choice_.together() && loader_.load(packet, first) && (!shears<Method> || packet.set_shear())) {
        RAYSWEEP_COUNT(count_, Visited::packet_begun);
        packet.budget = GroupChoice::budget;
        packet.has_news = 0;
        Stacks::restart(packet);
        return enlist(offset);
      }
      RAYSWEEP_COUNT(count_, Visited::packet_refused);
      alone_.push_back(static_cast<uint32_t>(first));
    }
  }

  HWY_INLINE void save(const Packet& packet) {
    const RayTag d;
    const RayWordTag dw;
    for (size_t at = 0; at < packet_size; at += rays_at_once) {
      const auto id = hn::Load(dw, packet.id + at);
      RayLanes t = hn::Load(d, packet.t + at);
      if constexpr (any)
        t = hn::IfThenElse(hn::RebindMask(d, hn::Eq(id, hn::Set(dw, no_hit_id))), t, hn::Neg(t));
      hn::Store(t, d, hits_.t.data() + packet.first + at);
      hn::Store(id, dw, hits_.id.data() + packet.first + at);
    }
  }

  HWY_INLINE void visit_node(uint32_t offset) {
    Packet& packet = packet_at(offset);
    const char* const node = reinterpret_cast<const char*>(nodes_ + packet.current);
    const auto meeting = packet.beam.meet(
        [node](size_t at) HWY_ATTR { return hn::Load(Floats(), reinterpret_cast<const float*>(node + at)); });
    const WordLanes children =
        hn::Load(Words(), reinterpret_cast<const uint32_t*>(node + offsetof(Node, children)));
    const uint32_t far_to_near = *reinterpret_cast<const uint32_t*>(node + packet.beam.order);
    stacks_.push_in_order(packet, children, meeting.enter, meeting.met, far_to_near);
    packet.budget--;
    RAYSWEEP_COUNT(count_, Visited::packet_node);
    go_on(offset);
  }

  /// Lists the triangles of a leaf's block that some ray may meet; how many.
  HWY_INLINE uint32_t visit_block(uint32_t offset, uint32_t* list) {
    const Floats d;
    const Words dw;
    Packet& packet = packet_at(offset);
    packet.block = child_index(packet.current);
    const bool is_spheres = (packet.current & sphere_bit) != 0;
    const Block& block = blocks_[packet.block];
    packet.more = block.more;
    RAYSWEEP_COUNT(count_, Visited::packet_block);
    stacks_.leave_block(packet, block.more);
    if (is_spheres) {
      RAYSWEEP_COUNT(count_, Visited::packet_test, block.count);
      for (uint32_t lane = 0; lane < block.count; ++lane)
        meet_sphere<any>(primitives_, packet, block.id[lane]);
      packet.budget -= static_cast<int32_t>(block.count);
      return 0;
    }
    packet.rows.set_boxes(boxes_of(d, corners_of(block)));
    const auto& axes = axes_of<Method>(packet.longest_axis);
    const auto prepared = prepare(Method{}, corners_of(block, axes));
    if (packet.has_one_origin) {
      const auto& from = packet.origin;
      const auto origin = broadcast(d, from[axes[0]][0], from[axes[1]][0], from[axes[2]][0]);
      packet.rows.set_vectors(seen_from(Method{}, origin, prepared));
    } else {
      packet.rows.set_vectors(prepared);
    }
    const auto meeting = packet.beam.meet(
        [&packet](size_t at) HWY_ATTR { return hn::Load(Floats(), packet.rows.box_row(at / row_bytes)); });
    const LaneMask is_there = hn::RebindMask(d, hn::Lt(hn::Iota(dw, 0), hn::Set(dw, block.count)));
    const Compaction kept(hn::And(meeting.met, is_there));
    hn::StoreU(kept(hn::Or(hn::Iota(dw, 0), hn::Set(dw, offset))), dw, list);
    packet.budget -= static_cast<int32_t>(1 + kept.count());
    return kept.count();
  }

  /// Where one triangle meets all rays; whether it does.
  HWY_INLINE uint32_t test(uint32_t word, uint32_t candidate) {
    const auto [offset, lane] = test_of(word);
    const Packet& packet = packet_at(offset);
    RAYSWEEP_COUNT(count_, Visited::packet_test);
    candidates_[candidate] = word;
    // All packets of a batch take the same way, or nearly all.
    const bool is_met = packet.has_one_origin ? solve_all<Method, true>(packet, lane, distances_[candidate])
                                              : solve_all<Method, false>(packet, lane, distances_[candidate]);
    return is_met ? 1 : 0;
  }

  HWY_INLINE void look_at(uint32_t word, const float* distances) {
    const RayTag d;
    const auto [offset, lane] = test_of(word);
    Packet& packet = packet_at(offset);
    const Block& block = blocks_[packet.block];
    const Corners<RayTag> corners{spread(block.corners, lane), spread(block.corners + 3, lane),
                                  spread(block.corners + 6, lane)};
    const Lanes3<RayTag> normal = spread(block.normal, lane);
    RAYSWEEP_COUNT(count_, Visited::packet_look);
    const LaneBoxes<RayTag> boxes = packet.rows.box(lane);
    for (size_t at = 0; at < packet_size; at += rays_at_once) {
      const RayLanes t = hn::Load(d, distances + at);
      const AcceptedHits<RayTag> hits =
          accept(Method{}, d, load_rays(packet.origin, at), load_rays(packet.direction, at),
                 load_rays(packet.reciprocal, at), boxes, corners, normal, t);
      const RayMask is_candidate = hn::Lt(t, hn::Set(d, std::numeric_limits<float>::infinity()));
      keep<any>(packet, at, hits.t, hn::And(is_candidate, hits.accepted), block.id[lane]);
    }
    if constexpr (Method::is_watertight) {
      for (size_t i = 0; i < packet_size; ++i)
        if (std::isnan(distances[i])) decide(packet, i, block.id[lane]);
    }
  }

  /// Whether ray `i` meets a triangle of which lanes cannot tell.
  HWY_INLINE void decide(Packet& packet, size_t i, uint32_t id) {
    const auto of_ray = [i](const PacketRows& rows) { return Vec3f(rows[0][i], rows[1][i], rows[2][i]); };
    const Ray<float> ray{of_ray(packet.origin), of_ray(packet.direction)};
    const auto t =
        primitives_.accept_triangle(id, std::numeric_limits<float>::quiet_NaN(), ray,
                                    SlabRay<float>(ray, of_ray(packet.reciprocal)), Hit<float>::start());
    if (!t || !(any ? *t < packet.t[i] : Hit<float>{*t, id}.before({packet.t[i], packet.id[i]}))) return;
    packet.t[i] = any ? -*t : *t;
    packet.id[i] = id;
    packet.has_news = 1;
  }

  HWY_INLINE void leave_block(uint32_t offset) {
    Packet& packet = packet_at(offset);
    if (std::exchange(packet.has_news, 0) != 0) {
      const RayTag d;
      RayLanes most = hn::Load(d, packet.t);
      for (size_t at = rays_at_once; at < packet_size; at += rays_at_once)
        most = hn::Max(most, hn::Load(d, packet.t + at));
      const float limit = hn::GetLane(hn::MaxOfLanes(d, most)) * widening;
      if constexpr (any) {
        if (limit < 0) packet.current = sentinel;
      } else if (limit < packet.beam.limit) {
        packet.beam.limit = limit;
        stacks_.shorten(packet, limit, packet.more);
      }
    }
    go_on(offset);
  }

  const Primitives<float, Method>& primitives_;
  const Node* const nodes_;
  const Block* const blocks_;
  HitBatch& hits_;
  const size_t ray_count_;
  std::vector<uint32_t>& alone_;
  [[no_unique_address]] const VisitCounter count_;
  const PacketLoader<any> loader_;
  GroupChoice& choice_;
  char* packets_;
  Stacks stacks_;
  float (*distances_)[packet_size];
  uint32_t *nodes_next_, *nodes_now_, *leaves_next_, *leaves_now_, *candidates_, *tests_;
  uint32_t next_node_count_ = 0, next_leaf_count_ = 0;
  size_t next_ = 0;  // the first ray not looked at
};

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#endif
