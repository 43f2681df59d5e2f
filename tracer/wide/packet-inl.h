// A packet of rays with what they have met.
#if defined(RAYSWEEP_WIDE_PACKET_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYSWEEP_WIDE_PACKET_INL_H_
#undef RAYSWEEP_WIDE_PACKET_INL_H_
#else
#define RAYSWEEP_WIDE_PACKET_INL_H_
#endif

#include <bit>

#include "tracer/wide/beam-inl.h"
#include "tracer/wide/nearest-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raysweep {
namespace HWY_NAMESPACE {

/// Of a block, a triangle a lane, what rays in lanes take one number of at a time.
class alignas(64) BlockRows {
 public:
  HWY_INLINE void set_boxes(const LaneBoxes<Floats>& of) {
    const Floats d;
    hn::Store(of.lower.x, d, boxes_[0]);
    hn::Store(of.upper.x, d, boxes_[1]);
    hn::Store(of.lower.y, d, boxes_[2]);
    hn::Store(of.upper.y, d, boxes_[3]);
    hn::Store(of.lower.z, d, boxes_[4]);
    hn::Store(of.upper.z, d, boxes_[5]);
  }
  /// In the order of a wide node's.
  [[nodiscard]] HWY_INLINE const float* box_row(size_t row) const { return boxes_[row]; }
  [[nodiscard]] HWY_INLINE LaneBoxes<RayTag> box(size_t lane) const {
    const auto& rows = boxes_;
    const RayTag d;
    return {broadcast(d, rows[0][lane], rows[2][lane], rows[4][lane]),
            broadcast(d, rows[1][lane], rows[3][lane], rows[5][lane])};
  }

  /// What a method knows of the triangles, in the order that it takes axes in.
  template <size_t count>
  HWY_INLINE void set_vectors(const TriangleVectors<Floats, count>& of) {
    static_assert(count <= most_vectors);
    const Floats d;
    for (size_t i = 0; i < count; ++i) {
      hn::Store(of.v[i].x, d, vectors_[3 * i]);
      hn::Store(of.v[i].y, d, vectors_[3 * i + 1]);
      hn::Store(of.v[i].z, d, vectors_[3 * i + 2]);
    }
  }
  template <class Vectors>
  [[nodiscard]] HWY_INLINE Vectors vectors(size_t lane) const {
    Vectors of;
    for (size_t i = 0; i < std::size(of.v); ++i) of.v[i] = spread(vectors_ + 3 * i, lane);
    return of;
  }

 private:
  static constexpr size_t most_vectors = 4;

  float boxes_[6][lane_count];
  float vectors_[3 * most_vectors][lane_count];
};

/// As many as keep what they hold in the first cache, or little more.
inline constexpr uint32_t packets_in_flight = 24;

struct alignas(64) Packet : StackPlace {
  alignas(64) PacketRows origin, direction, reciprocal;
  PacketRows offset;     // a ray meets planes at t = plane·reciprocal + offset, as in Slot
  float t[packet_size];  // nearest hits so far; any: negative where one is known
  uint32_t id[packet_size];
  // For methods that shear: how much, and the longest axes of directions.
  PacketRows shear;
  float axes[packet_size];
  Beam beam;
  uint32_t first;      // of its rays
  WideChild child;     // visited
  uint32_t active;     // rays that meet the box of `child`, a bit each
  uint32_t is_tested;  // whether that is to be asked
  uint32_t has_news;
  uint32_t has_one_origin;
  uint32_t has_one_axis;  // that is longest of all directions
  uint32_t longest_axis;  // that, or the last: how triangles are turned for all rays
  uint32_t cost;          // so far, in cycles: see StepCosts

  /// For methods that shear.
  HWY_INLINE void set_shear() {
    const RayTag d;
    RayMask differs = hn::FirstN(d, 0);
    for (size_t at = 0; at < packet_size; at += rays_at_once) {
      const Lanes3<RayTag> along = load_rays(direction, at);
      const RayLanes axis = LongestAxis<RayTag>(along).number();
      hn::Store(axis, d, axes + at);
      differs = hn::Or(differs, hn::Ne(axis, hn::Set(d, axes[0])));
      const Lanes3<RayTag> swapped = AxisSwap<RayTag>(axis)(along);
      const RayLanes inverse = hn::Div(hn::Set(d, 1.0f), swapped.z);
      hn::Store(hn::Mul(swapped.x, inverse), d, shear[0] + at);
      hn::Store(hn::Mul(swapped.y, inverse), d, shear[1] + at);
      hn::Store(inverse, d, shear[2] + at);
    }
    has_one_axis = hn::AllFalse(d, differs) ? 1 : 0;
    longest_axis = has_one_axis != 0 ? static_cast<uint32_t>(axes[0]) : 2;
  }
};

/// The rays that meet a box before `t`, a bit each. `plane(axis, side)`: its lower or upper bound.
template <class Plane>
HWY_INLINE uint32_t rays_that_meet(const Lanes3<RayTag>& reciprocal, const Lanes3<RayTag>& offset, RayLanes t,
                                   const Plane& plane) {
  const RayTag d;
  const auto meet = [&](size_t axis, size_t side, RayLanes slope, RayLanes from)
                        HWY_ATTR { return hn::MulAdd(hn::Set(RayTag(), plane(axis, side)), slope, from); };
  const RayLanes x0 = meet(0, 0, reciprocal.x, offset.x), x1 = meet(0, 1, reciprocal.x, offset.x),
                 y0 = meet(1, 0, reciprocal.y, offset.y), y1 = meet(1, 1, reciprocal.y, offset.y),
                 z0 = meet(2, 0, reciprocal.z, offset.z), z1 = meet(2, 1, reciprocal.z, offset.z);
  const RayLanes enter =
      hn::Max(hn::Max(hn::Min(x0, x1), hn::Min(y0, y1)), hn::Max(hn::Min(z0, z1), hn::Zero(d)));
  const RayLanes leave = hn::Min(hn::Max(x0, x1), hn::Min(hn::Max(y0, y1), hn::Max(z0, z1)));
  return bits_of(hn::Le(enter, hn::Mul(hn::Min(leave, t), hn::Set(d, widening))));
}
template <class Plane>
HWY_INLINE uint32_t rays_that_meet(const Packet& packet, const Plane& plane) {
  const RayTag d;
  uint32_t bits = 0;
  for (size_t at = 0; at < packet_size; at += rays_at_once)
    bits |= rays_that_meet(load_rays(packet.reciprocal, at), load_rays(packet.offset, at),
                           hn::Load(d, packet.t + at), plane)
            << at;
  return bits;
}

/// Children of a node that one ray meets.
HWY_INLINE Meeting meet_of_ray(const Packet& packet, size_t ray, const WideNode<lane_count>& node) {
  const Floats d;
  const auto row = [&node](size_t axis, size_t side)
                       HWY_ATTR { return hn::Load(Floats(), node.bounds[axis][side]); };
  const auto meet = [&](size_t axis, size_t side) HWY_ATTR {
    return hn::MulAdd(row(axis, side), hn::Set(Floats(), packet.reciprocal[axis][ray]),
                      hn::Set(Floats(), packet.offset[axis][ray]));
  };
  const FloatLanes x0 = meet(0, 0), x1 = meet(0, 1), y0 = meet(1, 0), y1 = meet(1, 1), z0 = meet(2, 0),
                   z1 = meet(2, 1);
  const FloatLanes enter =
      hn::Max(hn::Max(hn::Min(x0, x1), hn::Min(y0, y1)), hn::Max(hn::Min(z0, z1), hn::Zero(d)));
  const FloatLanes leave = hn::Min(hn::Max(x0, x1), hn::Min(hn::Max(y0, y1), hn::Max(z0, z1)));
  const FloatLanes limit = hn::Mul(hn::Min(leave, hn::Set(d, packet.t[ray])), hn::Set(d, widening));
  // The planes of a child that is not there are in reverse order.
  const LaneMask is_there = hn::Le(row(0, 0), row(0, 1));
  return {enter, hn::And(hn::Le(enter, limit), is_there)};
}

/// The octant that a ray goes to, as in WideNode::far_to_near.
HWY_INLINE uint32_t octant_of(const Packet& packet, size_t ray) {
  const auto falls = [&](size_t axis) { return std::bit_cast<uint32_t>(packet.reciprocal[axis][ray]) >> 31; };
  return falls(0) + 2 * falls(1) + 4 * falls(2);
}

/// The octant in whose order rays to `octant` visit children. Where any hit will do, far ones come first:
/// what is near is mostly the surface that rays have just left.
template <bool any>
HWY_INLINE uint32_t visited_octant(uint32_t octant) {
  return any ? octant ^ 7 : octant;
}

template <class Method>
HWY_INLINE OneRay ray_of(const Packet& packet, size_t i) {
  return {point_of(packet.origin, i), point_of(packet.direction, i), point_of(packet.reciprocal, i),
          shears<Method> ? static_cast<uint32_t>(packet.axes[i]) : 0};
}

/// What a method knows of the rays in lanes from `at` on and one triangle of `rows` before it divides.
template <class Method, bool has_one_origin>
HWY_INLINE auto project_rays(const Packet& packet, size_t at, const BlockRows& rows, size_t lane) {
  const RayTag d;
  using Prepared = decltype(prepare(Method{}, Corners<RayTag>{}));
  using Seen = decltype(seen_from(Method{}, Lanes3<RayTag>{}, Prepared{}));
  const auto vectors = rows.template vectors<std::conditional_t<has_one_origin, Seen, Prepared>>(lane);
  Seen seen;
  if constexpr (has_one_origin) {
    seen = vectors;
  } else {
    const auto& axes = axes_of<Method>(packet.longest_axis);
    const auto& from = packet.origin;
    seen = seen_from(Method{},
                     Lanes3<RayTag>{hn::Load(d, from[axes[0]] + at), hn::Load(d, from[axes[1]] + at),
                                    hn::Load(d, from[axes[2]] + at)},
                     vectors);
  }
  if constexpr (shears<Method>) {
    if (packet.has_one_axis == 0) seen = AxisSwap<RayTag>(hn::Load(d, packet.axes + at))(seen);
  }
  return project(Method{}, load_rays(shears<Method> ? packet.shear : packet.direction, at), seen);
}

/// Keeps hits that are nearer than the rays' own, or, of any, ends the rays.
template <bool any>
HWY_INLINE void keep(Packet& packet, size_t at, RayLanes t, RayMask accepted, uint32_t with) {
  const RayTag d;
  const RayWordTag dw;
  const RayLanes before = hn::Load(d, packet.t + at);
  const auto id = hn::Set(dw, with), ids = hn::Load(dw, packet.id + at);
  RayMask is_nearer = hn::Lt(t, before);
  if constexpr (!any)
    is_nearer = hn::Or(is_nearer, hn::And(hn::Eq(t, before), hn::RebindMask(d, hn::Lt(id, ids))));
  const RayMask kept = hn::And(accepted, is_nearer);
  packet.has_news |= hn::AllFalse(d, kept) ? 0 : 1;
  hn::Store(hn::IfThenElse(kept, any ? hn::Neg(t) : t, before), d, packet.t + at);
  hn::Store(hn::IfThenElse(hn::RebindMask(dw, kept), id, ids), dw, packet.id + at);
}

/// The same of one ray.
template <bool any>
HWY_INLINE void keep_of_ray(Packet& packet, size_t i, const Hit<float>& hit) {
  const Hit<float> before{packet.t[i], packet.id[i]};
  const bool is_kept = any ? hit.t < before.t : hit.before(before);
  packet.t[i] = is_kept ? (any ? -hit.t : hit.t) : before.t;
  packet.id[i] = is_kept ? hit.id : before.id;
  packet.has_news |= is_kept ? 1 : 0;
}

template <bool any, class Method>
HWY_INLINE void meet_sphere(const Primitives<float, Method>& primitives, Packet& packet, uint32_t id) {
  const RayTag d;
  const SphereShape<float>& sphere = primitives.sphere_shape(id);
  const Box<float>& box = primitives.box(id);
  const Lanes3<RayTag> centre = broadcast(d, sphere.centre.x, sphere.centre.y, sphere.centre.z);
  const LaneBoxes<RayTag> boxes{broadcast(d, box.lower().x, box.lower().y, box.lower().z),
                                broadcast(d, box.upper().x, box.upper().y, box.upper().z)};
  for (size_t at = 0; at < packet_size; at += rays_at_once) {
    const Lanes3<RayTag> origin = load_rays(packet.origin, at), reciprocal = load_rays(packet.reciprocal, at);
    const LaneSphereHits<RayTag> met =
        solve_sphere(d, origin, load_rays(packet.direction, at), centre, hn::Set(d, sphere.radius));
    const AcceptedHits<RayTag> enter = hold(d, origin, reciprocal, boxes, met.enter),
                               leave = hold(d, origin, reciprocal, boxes, met.leave);
    keep<any>(packet, at, hn::IfThenElse(enter.accepted, enter.t, leave.t),
              hn::And(met.is_met, hn::Or(enter.accepted, leave.accepted)), id);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#endif
