// Loads packets of rays that go the same way, and aims their beams.
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

/// Loads packets and makes their beams.
///
/// Rays towards one point, such as a light, are looked at from there: from their ends E = O + t_max·D
/// backwards, where the beam is narrow over its whole length. Let u = 2⁻²⁴. Where `slab` keeps a box, the
/// exact ray passes within 15u(|O| + |p|) of it, p being the box's farthest plane: 3 roundings of each end of
/// the interval and its widening. A computed end is off by 3u(2|O| + |E|). Ends are moved by 32u(|O| + |E| +
/// |p|), which is more; the roundings of the beam's own operations are outweighed as Slot's are.
enum class Loaded { ready, misses_everything, irregular };

template <bool any>
class PacketLoader {
 public:
  HWY_INLINE PacketLoader(const RayBatch& rays, const HitBatch& hits, const Box<float>& bounds)
      : rays_(rays),
        hits_(hits),
        bounds_(bounds),
        size_(std::max(max_abs(bounds.lower()), max_abs(bounds.upper()))) {}

  /// Loads rays `first` and following into `packet`, if they are regular and some may meet something.
  HWY_INLINE Loaded load(Packet& packet, size_t first) const {
    if (!are_regular(first)) return Loaded::irregular;
    load_hits(packet, first);
    for (size_t at = 0; at < packet_size; at += rays_at_once) load_rays_at(packet, first, at);
    const auto bound = [this](size_t axis, size_t side)
                           HWY_ATTR { return bounds_.bounds[side][static_cast<int>(axis)]; };
    if (rays_that_meet(packet, bound) == 0) return Loaded::misses_everything;
    packet.first = static_cast<uint32_t>(first);
    aim(packet, first);
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

  HWY_INLINE void load_hits(Packet& packet, size_t first) const {
    const RayTag d;
    const RayWordTag dw;
    for (size_t at = 0; at < packet_size; at += rays_at_once) {
      const auto id = hn::Load(dw, hits_.id.data() + first + at);
      RayLanes t = hn::Load(d, hits_.t.data() + first + at);
      if constexpr (any)
        t = hn::IfThenElse(hn::RebindMask(d, hn::Eq(id, hn::Set(dw, no_hit_id))), t, hn::Neg(t));
      hn::Store(t, d, packet.t + at);
      hn::Store(id, dw, packet.id + at);
    }
  }

  HWY_INLINE void load_rays_at(Packet& packet, size_t first, size_t at) const {
    const RayTag d;
    const RayLanes one = hn::Set(d, 1.0f);
    const size_t ray = first + at;
    const Lanes3<RayTag> origin = load(rays_.origin_x, rays_.origin_y, rays_.origin_z, ray),
                         direction = load(rays_.direction_x, rays_.direction_y, rays_.direction_z, ray),
                         reciprocal{hn::Div(one, direction.x), hn::Div(one, direction.y),
                                    hn::Div(one, direction.z)},
                         offset{hn::Neg(hn::Mul(origin.x, reciprocal.x)),
                                hn::Neg(hn::Mul(origin.y, reciprocal.y)),
                                hn::Neg(hn::Mul(origin.z, reciprocal.z))};
    store(origin, packet.origin, at);
    store(direction, packet.direction, at);
    store(reciprocal, packet.reciprocal, at);
    store(offset, packet.offset, at);
    const RayLanes worst = hn::Max(hn::Max(hn::Abs(offset.x), hn::Abs(offset.y)), hn::Abs(offset.z));
    hn::Store(hn::MulAdd(worst, hn::Set(d, 3 * offset_error), hn::Set(d, 3 * smallest)), d,
              packet.slack + at);
  }

  HWY_INLINE void aim(Packet& packet, size_t first) const {
    const RayTag d;
    const RayLanes zero = hn::Zero(d);
    RangesOf origins, directions, ends;
    for (size_t at = 0; at < packet_size; at += rays_at_once) {
      const Lanes3<RayTag> origin = load_rays(packet.origin, at), direction = load_rays(packet.direction, at);
      const RayLanes t = hn::Load(d, packet.t + at);
      if (at == 0) {
        origins.begin(origin, zero);
        directions.begin(direction, t);
      } else {
        origins.include(origin, zero);
        directions.include(direction, t);
      }
      if constexpr (any) {
        const Lanes3<RayTag> end = end_of(origin, direction, first + at);
        at == 0 ? ends.begin(end, zero) : ends.include(end, zero);
      }
    }
    const Ranges from = origins.get(), along = directions.get();
    packet.has_one_origin = !any && from.extent() == 0 ? 1 : 0;
    packet.beam.limit = hn::ExtractLane(along.most, 3) * widening;
    packet.beam.order = order_of(along);
    if (!any || !aim_back(packet.beam, from, ends, along)) packet.beam.aim(from, along);
  }

  [[nodiscard]] HWY_INLINE Lanes3<RayTag> end_of(const Lanes3<RayTag>& origin,
                                                 const Lanes3<RayTag>& direction, size_t ray) const {
    const RayLanes t = hn::Load(RayTag(), rays_.t_max.data() + ray);
    return {hn::Add(origin.x, hn::Mul(direction.x, t)), hn::Add(origin.y, hn::Mul(direction.y, t)),
            hn::Add(origin.z, hn::Mul(direction.z, t))};
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
    uint8_t falls[8];  // Highway writes up to 8 bytes
    hn::StoreMaskBits(Axes(), hn::Lt(hn::Add(along.least, along.most), hn::Zero(Axes())), falls);
    return static_cast<uint32_t>(offsetof(WideNode<lane_count>, far_to_near)) + (falls[0] & 7u) * 4;
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
  const HitBatch& hits_;
  const Box<float>& bounds_;
  const float size_;  // of the scene: its largest coordinate
};

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#endif
