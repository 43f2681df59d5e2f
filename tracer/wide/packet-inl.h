// A packet of rays with what they have met.
#if defined(RAYSWEEP_WIDE_PACKET_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYSWEEP_WIDE_PACKET_INL_H_
#undef RAYSWEEP_WIDE_PACKET_INL_H_
#else
#define RAYSWEEP_WIDE_PACKET_INL_H_
#endif

#include "tracer/wide/beam-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raysweep {
namespace HWY_NAMESPACE {

struct alignas(64) Packet : StackPlace {
  alignas(64) PacketRows origin, direction, reciprocal;
  float t[packet_size];  // nearest hits so far; any: negative where one is known
  uint32_t id[packet_size];
  Beam beam;
  uint32_t first;  // of its rays
  uint32_t more;   // of the block visited last
  uint32_t has_news;
  int32_t budget;
};

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
