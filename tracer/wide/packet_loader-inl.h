// Loads packets of rays, and aims their beams.
#if defined(RAYSWEEP_WIDE_PACKET_LOADER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYSWEEP_WIDE_PACKET_LOADER_INL_H_
#undef RAYSWEEP_WIDE_PACKET_LOADER_INL_H_
#else
#define RAYSWEEP_WIDE_PACKET_LOADER_INL_H_
#endif

#include "tracer/wide/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raysweep {
namespace HWY_NAMESPACE {

/// What became of a group of rays that was to be a packet.
enum class Loaded { ready, misses_everything, irregular };

/// Loads packets and makes their beams.
///
/// Rays towards one point, such as a light, are looked at from there: from their ends E = O + t_max·D
/// backwards, where the beam is narrow over its whole length. Let u = 2⁻²⁴. Where `slab` keeps a box, the
/// exact ray passes within 15u(|O| + |p|) of it, p being the box's farthest plane: 3 roundings of each end of
/// the interval and its widening. A computed end is off by 3u(2|O| + |E|). Ends are moved by 32u(|O| + |E| +
/// |p|), which is more; the roundings of the beam's own operations are outweighed as Slot's are.
template <bool any>
class PacketLoader {
 public:
  HWY_INLINE PacketLoader(const RayBatch& rays, HitBatch& hits, const Box<float>& bounds, bool begins_hits)
      : rays_(rays),
        hits_(hits),
        bounds_(bounds),
        begins_hits_(begins_hits),
        size_(std::max(max_abs(bounds.lower()), max_abs(bounds.upper()))) {}

  /// Loads rays `first` and following into `packet`, if they are regular and some may meet something.
  HWY_INLINE Loaded load(Packet& packet, size_t first) const {
    if (begins_hits_) {
      for (size_t at = 0; at < packet_size; at += rays_at_once)
        begin_hits(RayTag(), rays_, hits_, first + at);
    }
    if (!are_regular(first)) return Loaded::irregular;
    Rays rays[packet_size / rays_at_once];
    uint32_t meeting = 0;
    for (size_t at = 0; at < packet_size; at += rays_at_once)
      meeting |= load_at(rays[at / rays_at_once], packet, first + at, at);
    if (meeting == 0) return Loaded::misses_everything;
    for (size_t at = 0; at < packet_size; at += rays_at_once) store(rays[at / rays_at_once], packet, at);
    packet.first = static_cast<uint32_t>(first);
    aim(packet, rays, first);
    return Loaded::ready;
  }

 private:
  [[nodiscard]] HWY_INLINE bool are_regular(size_t first) const {
    const RayTag d;
    RayMask is_regular = hn::FirstN(d, rays_at_once);
    for (size_t at = 0; at < packet_size; at += rays_at_once) {
      const size_t ray = first + at;
      const Lanes3<RayTag> from = load(rays_.origin_x, rays_.origin_y, rays_.origin_z, ray),
                           along = load(rays_.direction_x, rays_.direction_y, rays_.direction_z, ray);
      const RayLanes x = hn::Abs(along.x), y = hn::Abs(along.y), z = hn::Abs(along.z);
      // What is not a number stays in a sum.
      const RayLanes sum = hn::Add(hn::Add(hn::Add(x, y), hn::Add(z, hn::Abs(from.x))),
                                   hn::Add(hn::Abs(from.y), hn::Abs(from.z)));
      const RayLanes t = hn::Load(d, hits_.t.data() + ray);
      is_regular = hn::And(hn::And(is_regular, hn::Eq(t, t)),
                           hn::And(hn::Ge(hn::Min(hn::Min(x, y), z), hn::Set(d, regular_low)),
                                   hn::Le(sum, hn::Set(d, regular_high))));
    }
    return hn::AllTrue(d, is_regular);
  }

  struct Rays {
    Lanes3<RayTag> origin, direction, reciprocal, offset;
    RayLanes t;
  };

  /// Whether any meets the box around everything. Of the packet only hits are set: those at hand.
  HWY_INLINE uint32_t load_at(Rays& rays, Packet& packet, size_t first, size_t at) const {
    const RayTag d;
    const RayWordTag dw;
    const RayLanes one = hn::Set(d, 1.0f);
    rays.origin = load(rays_.origin_x, rays_.origin_y, rays_.origin_z, first);
    rays.direction = load(rays_.direction_x, rays_.direction_y, rays_.direction_z, first);
    const auto& [from, along, reciprocal, offset, t] = rays;
    rays.reciprocal = {hn::Div(one, along.x), hn::Div(one, along.y), hn::Div(one, along.z)};
    rays.offset = {hn::Neg(hn::Mul(from.x, reciprocal.x)), hn::Neg(hn::Mul(from.y, reciprocal.y)),
                   hn::Neg(hn::Mul(from.z, reciprocal.z))};
    rays.t = hn::Load(d, hits_.t.data() + first);
    const auto id = hn::Load(dw, hits_.id.data() + first);
    if constexpr (any)
      rays.t = hn::IfThenElse(hn::RebindMask(d, hn::Eq(id, hn::Set(dw, no_hit_id))), t, hn::Neg(t));
    hn::Store(id, dw, packet.id + at);
    const auto bound = [this](size_t axis, size_t side)
                           HWY_ATTR { return bounds_.bounds[side][static_cast<int>(axis)]; };
    return rays_that_meet(reciprocal, offset, t, bound);
  }

  HWY_INLINE static void store(const Rays& rays, Packet& packet, size_t at) {
    const RayTag d;
    store(rays.origin, packet.origin, at);
    store(rays.direction, packet.direction, at);
    store(rays.reciprocal, packet.reciprocal, at);
    store(rays.offset, packet.offset, at);
    hn::Store(rays.t, d, packet.t + at);
  }

  template <size_t count>
  HWY_INLINE void aim(Packet& packet, const Rays (&rays)[count], size_t first) const {
    const RayLanes zero = hn::Zero(RayTag());
    RangesOf origins(rays[0].origin, zero), directions(rays[0].direction, rays[0].t),
        ends(end_of(rays[0], first), zero);
    for (size_t i = 1; i < count; ++i) {
      origins.include(rays[i].origin, zero);
      directions.include(rays[i].direction, rays[i].t);
      if constexpr (any) ends.include(end_of(rays[i], first + i * rays_at_once), zero);
    }
    packet.has_one_origin = !any && are_equal(rays) ? 1 : 0;
    const Ranges from = packet.has_one_origin != 0 ? Ranges::of_one(packet.origin) : origins.get(),
                 along = directions.get();
    packet.beam.limit = hn::ExtractLane(along.most, 3) * widening;
    packet.beam.order = order_of(along);
    if (!any || !aim_back(packet.beam, from, ends, along)) packet.beam.aim(from, along);
  }

  /// Whether all begin at one place.
  template <size_t count>
  HWY_INLINE static bool are_equal(const Rays (&rays)[count]) {
    const RayTag d;
    const auto first = [&](RayLanes v) HWY_ATTR { return hn::Set(RayTag(), hn::GetLane(v)); };
    const Lanes3<RayTag> place{first(rays[0].origin.x), first(rays[0].origin.y), first(rays[0].origin.z)};
    RayMask same = hn::Eq(place.x, place.x);
    for (const Rays& of : rays)
      same = hn::And(same, hn::And(hn::And(hn::Eq(of.origin.x, place.x), hn::Eq(of.origin.y, place.y)),
                                   hn::Eq(of.origin.z, place.z)));
    return hn::AllTrue(d, same);
  }

  [[nodiscard]] HWY_INLINE Lanes3<RayTag> end_of(const Rays& rays, size_t first) const {
    const RayLanes t = hn::Load(RayTag(), rays_.t_max.data() + first);
    return {hn::Add(rays.origin.x, hn::Mul(rays.direction.x, t)),
            hn::Add(rays.origin.y, hn::Mul(rays.direction.y, t)),
            hn::Add(rays.origin.z, hn::Mul(rays.direction.z, t))};
  }

  /// Aims from the rays' ends, if those take less room; whether they do. Ends beyond what origins may be, or
  /// not finite, never do.
  HWY_INLINE bool aim_back(Beam& beam, const Ranges& from, const RangesOf& ends, const Ranges& along) const {
    const Ranges to = ends.get();
    const float by = 32 * unit_roundoff<float> * (from.size() + to.size() + size_);
    if (!(to.size() <= regular_high && to.extent() + 2 * by < from.extent())) return false;
    const AxisLanes way = hn::Set(Axes(), by);
    beam.aim({hn::Sub(to.least, way), hn::Add(to.most, way)}, along.negated());
    return true;
  }

  /// Where in a node the order of the octant is that directions lie in, or most of them.
  HWY_INLINE static uint32_t order_of(const Ranges& along) {
    const uint32_t falls = bits_of(hn::Lt(hn::Add(along.least, along.most), hn::Zero(Axes()))),
                   octant = visited_octant<any>(falls & 7);
    return static_cast<uint32_t>(offsetof(WideNode<lane_count>, far_to_near)) + octant * 4;
  }

  HWY_INLINE static Lanes3<RayTag> load(const LaneArray<float>& x, const LaneArray<float>& y,
                                        const LaneArray<float>& z, size_t at) {
    const RayTag d;
    return {hn::Load(d, x.data() + at), hn::Load(d, y.data() + at), hn::Load(d, z.data() + at)};
  }
  HWY_INLINE static void store(const Lanes3<RayTag>& v, PacketRows& rows, size_t at) {
    const RayTag d;
    hn::Store(v.x, d, rows[0] + at);
    hn::Store(v.y, d, rows[1] + at);
    hn::Store(v.z, d, rows[2] + at);
  }

  const RayBatch& rays_;
  HitBatch& hits_;
  const Box<float>& bounds_;
  const bool begins_hits_;
  const float size_;  // of the scene: its largest coordinate
};

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#endif
