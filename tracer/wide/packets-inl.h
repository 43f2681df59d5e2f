// Packets of neighbouring rays that go down a hierarchy together. A node's boxes are compared with a beam
// that holds all rays of a packet (Boulos, Wald & Shirley 2006, "Geometric and arithmetic culling methods for
// entire ray packets"), so that a node costs a packet little more than a ray. What a beam meets, hardly any
// of its rays may: so before a child is visited its box meets all rays at once, a ray a lane. That tells how
// many are still together, and what is cheapest for them: the beam, or each of two rays by itself; a leaf's
// triangles one by one with all rays, or its rays one by one with all triangles. As in Stream, several
// packets take turns, sorted by what they need next, without a branch that depends on a ray.
#if defined(RAYSWEEP_WIDE_PACKETS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYSWEEP_WIDE_PACKETS_INL_H_
#undef RAYSWEEP_WIDE_PACKETS_INL_H_
#else
#define RAYSWEEP_WIDE_PACKETS_INL_H_
#endif

#include <utility>

#include "tracer/wide/fetch-inl.h"
#include "tracer/wide/packet_leaves-inl.h"
#include "tracer/wide/packet_lists-inl.h"
#include "tracer/wide/packet_loader-inl.h"
#include "tracer/wide/two_steps-inl.h"
#include "tracer/wide/visit_choice-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raysweep {
namespace HWY_NAMESPACE {

template <class Method, bool any>
class Packets {
 public:
  using Geometry = WideGeometry<Method, lane_count>;
  using Node = WideNode<lane_count>;
  using Block = typename Geometry::Block;

  HWY_INLINE Packets(const Geometry& geometry, const RayBatch& rays, HitBatch& hits, KernelScratch& scratch)
      : nodes_(geometry.tree.nodes.data()),
        blocks_(geometry.blocks.data()),
        fetches_(is_large(geometry)),
        hits_(hits),
        ray_count_(rays.size),
        alone_(scratch.groups),
        count_(scratch.visits),
        loader_(rays, hits, geometry.tree.bounds, geometry.begins_hits()),
        choice_(scratch.choice(any)),
        leaves_(geometry, scratch) {
    const size_t stack_size = Stacks::size_for(geometry.tree);
    packets_ = static_cast<char*>(
        scratch.reserve(packets_in_flight * (sizeof(Packet) + stack_size * Stacks::entry_bytes) +
                        leaves_.bytes + PacketLists::size * sizeof(uint32_t)));
    char* const memory = leaves_.place(packets_ + packets_in_flight * sizeof(Packet), packets_);
    lists_.place(reinterpret_cast<uint32_t*>(stacks_.place(memory, packets_in_flight, stack_size)));
    for (uint32_t i = 0; i < packets_in_flight; ++i)
      stacks_.begin(*new (packets_ + i * sizeof(Packet)) Packet, i * stack_size);
  }

  /// Lists the groups whose rays have to go alone.
  HWY_INLINE void run() {
    for (uint32_t i = 0; i < packets_in_flight; ++i) begin_next(static_cast<uint32_t>(i * sizeof(Packet)));
    while (lists_.is_any_left()) {
      tested_count_ > 0 ? test_boxes() : go_on();
      end_packets();
      meet_leaves();
      visit_nodes_of_many();
      visit_nodes_of_few();
    }
    if (next_ < ray_count_) alone_.push_back(static_cast<uint32_t>(next_));
  }

 private:
  static_assert(sizeof(Packet) % packet_size == 0 && batch_lanes % packet_size == 0);
  using Kind = PacketLists::Kind;

  HWY_INLINE Packet& packet_at(uint32_t offset) const {
    return *reinterpret_cast<Packet*>(packets_ + offset);
  }

  HWY_NOINLINE HWY_ATTR void begin_next(uint32_t offset) {
    Packet& packet = packet_at(offset);
    while (next_ + packet_size <= ray_count_) {
      const size_t first = next_;
      next_ += packet_size;
      if (choice_.together()) {
        const Loaded loaded = loader_.load(packet, first);
        if (loaded == Loaded::misses_everything) {
          RAYSWEEP_COUNT(count_, Visited::packet_missed);
          continue;
        }
        if (loaded == Loaded::ready && !choice_.explores()) return begin(offset, packet);
      }
      RAYSWEEP_COUNT(count_, Visited::packet_refused);
      alone_.push_back(static_cast<uint32_t>(first));
    }
  }

  /// At the root.
  HWY_INLINE void begin(uint32_t offset, Packet& packet) {
    RAYSWEEP_COUNT(count_, Visited::packet_begun);
    if constexpr (shears<Method>) packet.set_shear();
    packet.has_news = 0;
    packet.cost = StepCosts::packet;
    // The beam of rays from one point holds hardly a box that none of them meets.
    packet.is_tested = 1 - (packet.has_one_origin & packet.beam.is_tight);
    tested_count_ += packet.is_tested;
    packet.child = 0;
    Stacks::restart(packet);
    lists_.add(Kind::node_of_many, offset);
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

  // Each a function of its own: see Stream.

  HWY_NOINLINE HWY_ATTR void end_packets() {
    const auto ended = lists_.take(Kind::ended);
    for (uint32_t i = 0; i < ended.count; ++i) {
      const Packet& packet = packet_at(ended.packets[i]);
      save(packet);
      choice_.went_together(packet.cost);
      tested_count_ -= packet.is_tested;
      begin_next(ended.packets[i]);
    }
  }

  /// Sorts packets by what they have popped.
  HWY_NOINLINE HWY_ATTR void go_on() {
    const auto popped = lists_.take(Kind::popped);
    uint32_t* const kinds = lists_.kinds();
    const Node* const nodes = nodes_;
    const Block* const blocks = blocks_;
    for (uint32_t i = 0; i < popped.count; ++i) {
      Packet& packet = packet_at(popped.packets[i]);
      const ChildPlace at(packet.current);
      packet.child = nodes[at.node].children[at.lane];
      const VisitChoice& choice = untested_visits[2 * is_at_end(packet) + (packet.child >> 31)];
      kinds[i] = go_to_child(nodes, blocks, packet, choice);
      RAYSWEEP_COUNT(count_, Visited::packet_child, 1 - is_at_end(packet));
    }
    lists_.sort(popped, {Kind::ended, Kind::node_of_many, Kind::leaf_of_many});
  }

  /// The same, by how many of their rays meet its box.
  HWY_NOINLINE HWY_ATTR void test_boxes() {
    const auto popped = lists_.take(Kind::popped);
    uint32_t* const kinds = lists_.kinds();
    const Node* const nodes = nodes_;
    const Block* const blocks = blocks_;
    const auto first = [&](uint32_t i) RAYSWEEP_STEP {
      Packet& packet = packet_at(popped.packets[i]);
      const ChildPlace at(packet.current);
      packet.child = nodes[at.node].children[at.lane];
      const auto& bounds = nodes[at.node].bounds;
      return rays_that_meet(packet,
                            [&](size_t axis, size_t side) HWY_ATTR { return bounds[axis][side][at.lane]; });
    };
    const auto second = [&](uint32_t active, uint32_t i) RAYSWEEP_STEP {
      Packet& packet = packet_at(popped.packets[i]);
      packet.active = active;
      const auto& choices = tested_visits[4 * is_at_end(packet) + (packet.child >> 30)];
      kinds[i] = go_to_child(nodes, blocks, packet, choices[hwy::PopCount(active)]);
      RAYSWEEP_COUNT(count_, Visited::packet_box, 1 - is_at_end(packet));
    };
    in_two_steps<1>(popped.count, first, second);
    lists_.sort(popped, {Kind::popped, Kind::ended, Kind::node_of_many, Kind::node_of_few, Kind::leaf_of_many,
                         Kind::leaf_of_few});
    for (uint32_t i = 0; i < lists_.count(Kind::popped); ++i)
      stacks_.pop(packet_at(lists_.packets(Kind::popped)[i]));
  }

  /// What the packet is to do about its child.
  HWY_INLINE uint32_t go_to_child(const Node* nodes, const Block* blocks, Packet& packet,
                                  const VisitChoice& choice) const {
    packet.block = child_index(packet.child);
    packet.cost += choice.cost;
    if (fetches_) fetch(nodes, blocks, packet.child);
    return choice.kind;
  }

  HWY_INLINE static uint32_t is_at_end(const Packet& packet) { return packet.top == packet.bottom ? 1 : 0; }

  HWY_NOINLINE HWY_ATTR void meet_leaves() {
    const auto together = lists_.take(Kind::leaf_of_many);
    if (together.count > 0) {
      leaves_.meet_together(together.packets, together.count, tested_count_ == 0);
      for (uint32_t i = 0; i < together.count; ++i) leave_block(together.packets[i], Kind::leaf_of_many);
    }
    const auto apart = lists_.take(Kind::leaf_of_few);
    if (apart.count > 0) {
      leaves_.meet_apart(apart.packets, apart.count);
      for (uint32_t i = 0; i < apart.count; ++i) leave_block(apart.packets[i], Kind::leaf_of_few);
    }
  }

  HWY_INLINE void leave_block(uint32_t offset, Kind kind) {
    Packet& packet = packet_at(offset);
    if (std::exchange(packet.has_news, 0) != 0 && look_at_news(packet)) {
      lists_.add(Kind::ended, offset);
    } else if (blocks_[packet.block].more != 0) {
      ++packet.block;
      packet.cost += StepCosts::leaf_together;
      lists_.add(kind, offset);
    } else {
      stacks_.pop(packet);
      lists_.add(Kind::popped, offset);
    }
  }

  /// Whether all rays are done.
  HWY_INLINE bool look_at_news(Packet& packet) {
    const RayTag d;
    RayLanes most = hn::Load(d, packet.t);
    for (size_t at = rays_at_once; at < packet_size; at += rays_at_once)
      most = hn::Max(most, hn::Load(d, packet.t + at));
    const float limit = hn::GetLane(hn::MaxOfLanes(d, most)) * widening;
    if constexpr (any) {
      return limit < 0;
    } else {
      if (limit < packet.beam.limit) {
        packet.beam.limit = limit;
        stacks_.shorten(packet, limit);
      }
      return false;
    }
  }

  HWY_NOINLINE HWY_ATTR void visit_nodes_of_many() {
    const auto visits = lists_.take(Kind::node_of_many);
    struct Step {
      Packet* packet;
      const char* node;
      FloatLanes enter;
    };
    const auto first = [&](uint32_t i) RAYSWEEP_STEP {
      Packet& packet = packet_at(visits.packets[i]);
      const auto* const node = reinterpret_cast<const char*>(nodes_ + packet.child);
      const auto plane = [node](size_t at) HWY_ATTR {
        return hn::Load(Floats(), reinterpret_cast<const float*>(node + at));
      };
      return Step{&packet, node, packet.beam.meet(plane).enter_if_met()};
    };
    const auto second = [&](const Step& step, uint32_t) RAYSWEEP_STEP {
      push(*step.packet, *reinterpret_cast<const Node*>(step.node), step.enter,
           *reinterpret_cast<const uint32_t*>(step.node + step.packet->beam.order));
      RAYSWEEP_COUNT(count_, Visited::packet_node);
    };
    in_two_steps<1>(visits.count, first, second);
    lists_.add(Kind::popped, visits);
  }

  HWY_NOINLINE HWY_ATTR void visit_nodes_of_few() {
    const auto visits = lists_.take(Kind::node_of_few);
    for (uint32_t i = 0; i < visits.count; ++i) {
      Packet& packet = packet_at(visits.packets[i]);
      const Node& node = nodes_[packet.child];
      const size_t first = hwy::Num0BitsBelowLS1Bit_Nonzero32(packet.active),
                   last = 31 - hwy::Num0BitsAboveMS1Bit_Nonzero32(packet.active);
      const Meeting one = meet_of_ray(packet, first, node), other = meet_of_ray(packet, last, node);
      const Meeting either{hn::Min(one.enter, other.enter), hn::Or(one.met, other.met)};
      push(packet, node, either.enter_if_met(),
           node.far_to_near[visited_octant<any>(octant_of(packet, first))]);
      RAYSWEEP_COUNT(count_, Visited::packet_node_of_few);
    }
    lists_.add(Kind::popped, visits);
  }

  HWY_INLINE void push(Packet& packet, const Node& node, FloatLanes enter, uint32_t far_to_near) const {
    const WordLanes places = ChildPlace::of_all(packet.child, hn::Load(Words(), node.children));
    stacks_.push_in_order(packet, places, enter, far_to_near);
  }

  const Node* const nodes_;
  const Block* const blocks_;
  const bool fetches_;
  HitBatch& hits_;
  const size_t ray_count_;
  std::vector<uint32_t>& alone_;
  [[no_unique_address]] const VisitCounter count_;
  const PacketLoader<any> loader_;
  GroupChoice& choice_;
  PacketLeaves<Method, any> leaves_;
  char* packets_;
  Stacks stacks_;
  PacketLists lists_;
  size_t next_ = 0;            // the first ray not looked at
  uint32_t tested_count_ = 0;  // packets in flight that want boxes tested: then those of all are
};

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#endif
