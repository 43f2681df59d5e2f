// A packet of rays, and the beam that holds them all.
#if defined(RAYSWEEP_WIDE_BEAM_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYSWEEP_WIDE_BEAM_INL_H_
#undef RAYSWEEP_WIDE_BEAM_INL_H_
#else
#define RAYSWEEP_WIDE_BEAM_INL_H_
#endif

#include "tracer/wide/ray_setup-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raysweep {
namespace HWY_NAMESPACE {

/// Rays in lanes: as many as vectors hold, a packet at most.
using RayTag = hn::CappedTag<float, packet_size>;
using RayWordTag = hn::RebindToUnsigned<RayTag>;
using RayLanes = hn::Vec<RayTag>;
using RayMask = hn::Mask<RayTag>;
inline constexpr size_t rays_at_once = HWY_MAX_BYTES >= 64 ? 16 : HWY_MAX_BYTES >= 32 ? 8 : 4;

using PacketRows = float[3][packet_size];

HWY_INLINE Lanes3<RayTag> load_rays(const PacketRows& rows, size_t at) {
  return load_rows(RayTag(), rows[0] + at, packet_size);
}
/// One triangle's numbers for every ray.
HWY_INLINE Lanes3<RayTag> spread(const float (*rows)[lane_count], size_t lane) {
  return broadcast(RayTag(), rows[0][lane], rows[1][lane], rows[2][lane]);
}

/// The smallest and the largest number of rows of a packet.
struct Extremes {
  float least, most;
};
class ExtremesOf {
 public:
  HWY_INLINE ExtremesOf()
      : least_(hn::Set(RayTag(), std::numeric_limits<float>::infinity())), most_(hn::Neg(least_)) {}
  HWY_INLINE void include(RayLanes v) {
    least_ = hn::Min(least_, v);
    most_ = hn::Max(most_, v);
  }
  [[nodiscard]] HWY_INLINE Extremes get() const {
    const RayTag d;
    return {hn::GetLane(hn::MinOfLanes(d, least_)), hn::GetLane(hn::MaxOfLanes(d, most_))};
  }

 private:
  RayLanes least_, most_;
};

/// When a packet meets planes: t = plane·slope + offset, for the first of its rays to enter and for the last
/// to leave. On each axis the rays' reciprocals lie between two numbers of one sign, and their origins
/// between two others. What is entered lies ahead, at a way of (plane − origin)·reciprocal ≥ 0, which is
/// least for the reciprocal next to 0 and the origin farthest along; where it is not ahead, less than 0 is
/// found as well, and 0 is taken. In the same way the last to leave has the largest reciprocal and the
/// hindmost origin. Offsets are moved to the safe side, and limits and far distances widened, as in Slot.
struct Beam {
  float near_slope[4], near_offset[4], far_slope[4], far_offset[4];
  uint32_t near_plane[4];  // as in Slot
  float limit;             // no ray asks for more

  HWY_INLINE void set_axis(size_t axis, const Extremes& reciprocals, const Extremes& origins) {
    const bool is_negative = reciprocals.most < 0;
    near_slope[axis] = is_negative ? reciprocals.most : reciprocals.least;
    far_slope[axis] = is_negative ? reciprocals.least : reciprocals.most;
    const float near_c = -(is_negative ? origins.least : origins.most) * near_slope[axis],
                far_c = -(is_negative ? origins.most : origins.least) * far_slope[axis];
    near_offset[axis] = near_c - (std::abs(near_c) * offset_error + smallest);
    far_offset[axis] = far_c + (std::abs(far_c) * offset_error + smallest);
    constexpr uint32_t row = lane_count * sizeof(float);
    near_plane[axis] = (static_cast<uint32_t>(axis) * 2 + (is_negative ? 1 : 0)) * row;
  }

  /// Boxes that some ray may be inside of, and when the first one is.
  struct Meeting {
    FloatLanes enter;
    LaneMask met;
  };
  /// `plane(row)`: lower bounds on x, upper ones, lower ones on y, and so on.
  template <class Plane>
  [[nodiscard]] HWY_INLINE Meeting meet(const Plane& plane) const {
    const Floats d;
    constexpr uint32_t row = lane_count * sizeof(float);
    const uint32_t x = near_plane[0], y = near_plane[1], z = near_plane[2];
    const auto at = [&](uint32_t planes, const float* slopes, const float* offsets, size_t axis) HWY_ATTR {
      return hn::MulAdd(plane(planes), hn::Set(Floats(), slopes[axis]), hn::Set(Floats(), offsets[axis]));
    };
    const FloatLanes enter =
        hn::Max(hn::Max(at(x, near_slope, near_offset, 0), at(y, near_slope, near_offset, 1)),
                hn::Max(at(z, near_slope, near_offset, 2), hn::Zero(d)));
    const FloatLanes leave =
        hn::Min(at(x ^ row, far_slope, far_offset, 0),
                hn::Min(at(y ^ row, far_slope, far_offset, 1), at(z ^ row, far_slope, far_offset, 2)));
    return {enter, hn::Le(enter, hn::Min(hn::Mul(leave, hn::Set(d, widening)), hn::Set(d, limit)))};
  }
};

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
  HWY_INLINE PacketLoader(const RayBatch& rays, const HitBatch& hits, const Box<float>& bounds)
      : rays_(rays), hits_(hits), size_(std::max(max_abs(bounds.lower()), max_abs(bounds.upper()))) {}

  /// Whether rays `first` and following are regular and have directions of equal signs; then `packet` holds
  /// them.
  template <class Packet>
  HWY_INLINE bool load(Packet& packet, size_t first) const {
    if (!is_alike(first)) return false;
    const RayTag d;
    const RayWordTag dw;
    const LaneArray<float>* const origins[3] = {&rays_.origin_x, &rays_.origin_y, &rays_.origin_z};
    const LaneArray<float>* const directions[3] = {&rays_.direction_x, &rays_.direction_y,
                                                   &rays_.direction_z};
    ExtremesOf limits;
    for (size_t at = 0; at < packet_size; at += rays_at_once) {
      const auto id = hn::Load(dw, hits_.id.data() + first + at);
      RayLanes t = hn::Load(d, hits_.t.data() + first + at);
      if constexpr (any)
        t = hn::IfThenElse(hn::RebindMask(d, hn::Eq(id, hn::Set(dw, no_hit_id))), t, hn::Neg(t));
      hn::Store(t, d, packet.t + at);
      hn::Store(id, dw, packet.id + at);
      limits.include(t);
    }
    Extremes from[3], to[3], reciprocals[3];
    for (size_t axis = 0; axis < 3; ++axis) {
      ExtremesOf all_origins, all_ends, all_reciprocals;
      for (size_t at = 0; at < packet_size; at += rays_at_once) {
        const RayLanes origin = hn::Load(d, origins[axis]->data() + first + at),
                       direction = hn::Load(d, directions[axis]->data() + first + at),
                       reciprocal = hn::Div(hn::Set(d, 1.0f), direction);
        hn::Store(origin, d, packet.origin[axis] + at);
        hn::Store(direction, d, packet.direction[axis] + at);
        hn::Store(reciprocal, d, packet.reciprocal[axis] + at);
        all_origins.include(origin);
        all_reciprocals.include(reciprocal);
        if constexpr (any)
          all_ends.include(hn::Add(origin, hn::Mul(direction, hn::Load(d, rays_.t_max.data() + first + at))));
      }
      from[axis] = all_origins.get();
      reciprocals[axis] = all_reciprocals.get();
      if constexpr (any) to[axis] = all_ends.get();
    }
    uint32_t octant = 0;
    for (uint32_t axis = 0; axis < 3; ++axis) octant |= (reciprocals[axis].most < 0 ? 1u : 0u) << axis;
    packet.beam.limit = limits.get().most * widening;
    const float by = 32 * unit_roundoff<float> * (largest(from) + largest(to) + size_);
    // Ends of which one is not finite never take less room.
    if (any && extent(to) + 2 * by < extent(from)) {
      turn_round(packet.beam, to, by, reciprocals);
    } else {
      for (size_t axis = 0; axis < 3; ++axis) packet.beam.set_axis(axis, reciprocals[axis], from[axis]);
    }
    packet.beam.near_plane[3] =
        static_cast<uint32_t>(offsetof(WideNode<lane_count>, far_to_near)) + octant * 4;
    packet.first = static_cast<uint32_t>(first);
    return true;
  }

 private:
  [[nodiscard]] HWY_INLINE bool is_alike(size_t first) const {
    const RayTag d;
    RayMask is_regular = hn::FirstN(d, rays_at_once);
    for (size_t at = 0; at < packet_size; at += rays_at_once) {
      const RayLanes t = hn::Load(d, hits_.t.data() + first + at);
      is_regular = hn::And(is_regular, hn::Eq(t, t));
    }
    const RayLanes high = hn::Set(d, regular_high), low = hn::Set(d, regular_low);
    bool has_one_sign = true;
    for (const auto* along : {&rays_.direction_x, &rays_.direction_y, &rays_.direction_z}) {
      bool has_positive = false, has_negative = false;
      for (size_t at = 0; at < packet_size; at += rays_at_once) {
        const RayLanes v = hn::Load(d, along->data() + first + at), size = hn::Abs(v);
        is_regular = hn::And(is_regular, hn::And(hn::Ge(size, low), hn::Le(size, high)));
        const RayMask is_negative = hn::Lt(v, hn::Zero(d));
        has_negative |= !hn::AllFalse(d, is_negative);
        has_positive |= !hn::AllTrue(d, is_negative);
      }
      has_one_sign &= !(has_negative && has_positive);
    }
    for (const auto* from : {&rays_.origin_x, &rays_.origin_y, &rays_.origin_z}) {
      for (size_t at = 0; at < packet_size; at += rays_at_once)
        is_regular = hn::And(is_regular, hn::Le(hn::Abs(hn::Load(d, from->data() + first + at)), high));
    }
    return has_one_sign && hn::AllTrue(d, is_regular);
  }

  [[nodiscard]] HWY_INLINE static float extent(const Extremes (&box)[3]) {
    return std::max({box[0].most - box[0].least, box[1].most - box[1].least, box[2].most - box[2].least});
  }
  [[nodiscard]] HWY_INLINE static float largest(const Extremes (&box)[3]) {
    float size = 0;
    for (const Extremes& e : box) size = std::max({size, std::abs(e.least), std::abs(e.most)});
    return size;
  }

  HWY_INLINE static void turn_round(Beam& beam, const Extremes (&to)[3], float by,
                                    const Extremes (&reciprocals)[3]) {
    for (size_t axis = 0; axis < 3; ++axis) {
      const Extremes moved{to[axis].least - by, to[axis].most + by};
      beam.set_axis(axis, {-reciprocals[axis].most, -reciprocals[axis].least}, moved);
    }
  }

  const RayBatch& rays_;
  const HitBatch& hits_;
  const float size_;  // of the scene: its largest coordinate
};

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#endif
