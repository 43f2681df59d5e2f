// The beam that holds all rays of a packet.
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

/// A row of a node: one plane of each child's box.
inline constexpr uint32_t row_bytes = lane_count * sizeof(float);

HWY_INLINE Lanes3<RayTag> load_rays(const PacketRows& rows, size_t at) {
  return load_rows(RayTag(), rows[0] + at, packet_size);
}
#if HWY_TARGET == HWY_AVX3  // elsewhere rays in lanes are as many as triangles
/// One bit a ray.
HWY_INLINE uint32_t bits_of(RayMask mask) { return mask.raw; }
#endif
/// One triangle's numbers for every ray.
HWY_INLINE Lanes3<RayTag> spread(const float (*rows)[lane_count], size_t lane) {
  return broadcast(RayTag(), rows[0][lane], rows[1][lane], rows[2][lane]);
}

/// The smallest and the largest numbers: of a packet's vectors by axis, and of one number more.
struct Ranges {
  AxisLanes least, most;

  /// Of rows whose numbers are all the same.
  HWY_INLINE static Ranges of_one(const PacketRows& rows) {
    alignas(16) const float v[4] = {rows[0][0], rows[1][0], rows[2][0], 0};
    return {hn::Load(Axes(), v), hn::Load(Axes(), v)};
  }
  [[nodiscard]] HWY_INLINE Ranges negated() const { return {hn::Neg(most), hn::Neg(least)}; }
  [[nodiscard]] HWY_INLINE float extent() const { return largest(hn::Sub(most, least)); }
  [[nodiscard]] HWY_INLINE float size() const { return largest(hn::Max(hn::Abs(most), hn::Abs(least))); }

 private:
  [[nodiscard]] HWY_INLINE static float largest(AxisLanes v) {
    return hn::GetLane(hn::MaxOfLanes(Axes(), v));
  }
};

class RangesOf {
 public:
  HWY_INLINE RangesOf(const Lanes3<RayTag>& v, RayLanes more) {
    const RayLanes all[4] = {v.x, v.y, v.z, more};
    for (size_t i = 0; i < 4; ++i) {
      least_[i] = all[i];
      least_[i + 4] = hn::Neg(all[i]);
    }
  }
  HWY_INLINE void include(const Lanes3<RayTag>& v, RayLanes more) {
    const RayLanes all[4] = {v.x, v.y, v.z, more};
    for (size_t i = 0; i < 4; ++i) {
      least_[i] = hn::Min(least_[i], all[i]);
      least_[i + 4] = hn::Min(least_[i + 4], hn::Neg(all[i]));
    }
  }
  /// Halves pairs of vectors into one until each has a lane: a third of what one after the other would take.
  [[nodiscard]] HWY_INLINE Ranges get() const {
    const RayTag d;
    RayLanes of[8];
    for (size_t i = 0; i < 8; ++i) of[i] = least_[i];
    size_t count = 8;
    for (size_t lanes = rays_at_once; lanes > 1; lanes /= 2) {
      const size_t half = std::max<size_t>(count / 2, 1);
      for (size_t i = 0; i < half; ++i) {
        const RayLanes a = of[2 * i], b = of[count > 1 ? 2 * i + 1 : 0];
        of[i] = hn::Min(hn::ConcatEven(d, b, a), hn::ConcatOdd(d, b, a));
      }
      count = half;
    }
    alignas(64) float all[16];
    for (size_t i = 0; i < count; ++i) hn::Store(of[i], d, all + i * rays_at_once);
    return {hn::Load(Axes(), all), hn::Neg(hn::Load(Axes(), all + 4))};
  }

 private:
  RayLanes least_[8];  // the last four: of the numbers negated
};

/// When a packet meets planes: t = plane·slope + offset, for the first of its rays to enter and for the last
/// to leave. Rays of a packet start between two origins and have directions between two others, by axis.
/// Where those are of one sign, what is entered lies ahead, at a way of (plane − origin)/direction ≥ 0, which
/// is least for the longest direction and the origin farthest along; where it is not ahead, less than 0 is
/// found as well, and 0 is taken. In the same way the last to leave has the shortest direction and the
/// hindmost origin. Where signs differ on one axis, rays that rise enter by its lower plane and those that
/// fall by the upper one, the first of them as above, no box is met before both, and some ray may stay inside
/// for ever. Where they differ on more, each of these axes has no say but for children that are not there.
/// Offsets are moved to the safe side, and limits and far distances widened, as in Slot.
struct alignas(16) Beam {
  /// The last of each near one is that of rays which fall while others rise; where there are none, the first
  /// one's again.
  float near_slope[4], near_offset[4], far_slope[4], far_offset[4];
  uint32_t near_plane[4];  // bytes into a node
  uint32_t order;          // as well: of the octant's order
  float limit;             // no ray asks for more
  uint32_t is_tight;       // whether every axis has a say

  HWY_INLINE void aim(const Ranges& from, const Ranges& along) {
    const Axes d;
    const AxisWords dw;
    const auto zero = hn::Zero(d), one = hn::Set(d, 1.0f);
    const auto falls = hn::Lt(along.most, zero);
    const auto near_s = hn::Div(one, hn::IfThenElse(falls, along.least, along.most)),
               far_s = hn::Div(one, hn::IfThenElse(falls, along.most, along.least)),
               near_c = hn::Neg(hn::Mul(hn::IfThenElse(falls, from.least, from.most), near_s)),
               far_c = hn::Neg(hn::Mul(hn::IfThenElse(falls, from.most, from.least), far_s));
    const auto error = [d](AxisLanes c) HWY_ATTR {
      return hn::Add(hn::Mul(hn::Abs(c), hn::Set(d, offset_error)), hn::Set(d, smallest));
    };
    hn::Store(near_s, d, near_slope);
    hn::Store(far_s, d, far_slope);
    hn::Store(hn::Sub(near_c, error(near_c)), d, near_offset);
    hn::Store(hn::Add(far_c, error(far_c)), d, far_offset);
    alignas(16) static constexpr uint32_t lower[4] = {0, 2 * row_bytes, 4 * row_bytes, 0};
    const auto upper = hn::IfThenElseZero(hn::RebindMask(dw, falls), hn::Set(dw, row_bytes));
    hn::Store(hn::Add(hn::Load(dw, lower), upper), dw, near_plane);
    const uint32_t mixed = mixed_axes(along);
    is_tight = (mixed & (mixed - 1)) == 0 ? 1 : 0;
    if (mixed == 0) {
      repeat_first();
    } else if (is_tight != 0) {
      const auto axis = hwy::Num0BitsBelowLS1Bit_Nonzero32(mixed);
      near_slope[3] = far_slope[axis];
      near_offset[3] = hn::ExtractLane(hn::Sub(far_c, error(far_c)), axis);
      near_plane[3] = near_plane[axis] ^ row_bytes;
      open_far_end(axis);
    } else {
      for (uint32_t left = mixed; left != 0; left &= left - 1) {
        const auto axis = hwy::Num0BitsBelowLS1Bit_Nonzero32(left);
        near_slope[axis] = smallest;
        near_offset[axis] = -1;
        open_far_end(axis);
      }
      repeat_first();
    }
  }

  /// `plane(row)`: lower bounds on x, upper ones, lower ones on y, and so on.
  template <class Plane>
  [[nodiscard]] HWY_INLINE Meeting meet(const Plane& plane) const {
    const Floats d;
    const uint32_t x = near_plane[0], y = near_plane[1], z = near_plane[2];
    const auto at = [&](uint32_t planes, const float* slopes, const float* offsets, size_t axis) HWY_ATTR {
      return hn::MulAdd(plane(planes), hn::Set(Floats(), slopes[axis]), hn::Set(Floats(), offsets[axis]));
    };
    const FloatLanes enter =
        hn::Max(hn::Max(hn::Max(at(x, near_slope, near_offset, 0), at(y, near_slope, near_offset, 1)),
                        hn::Max(at(z, near_slope, near_offset, 2), hn::Zero(d))),
                at(near_plane[3], near_slope, near_offset, 3));
    const FloatLanes leave = hn::Min(
        at(x ^ row_bytes, far_slope, far_offset, 0),
        hn::Min(at(y ^ row_bytes, far_slope, far_offset, 1), at(z ^ row_bytes, far_slope, far_offset, 2)));
    return {enter, hn::Le(enter, hn::Min(hn::Mul(leave, hn::Set(d, widening)), hn::Set(d, limit)))};
  }

 private:
  HWY_INLINE void repeat_first() {
    near_slope[3] = near_slope[0];
    near_offset[3] = near_offset[0];
    near_plane[3] = near_plane[0];
  }
  /// Still before everything for a child that is not there.
  HWY_INLINE void open_far_end(size_t axis) {
    far_slope[axis] = smallest;
    far_offset[axis] = std::numeric_limits<float>::max();
  }

  /// The axes on which directions have different signs, a bit each.
  HWY_INLINE static uint32_t mixed_axes(const Ranges& along) {
    const Axes d;
    const auto zero = hn::Zero(d);
    uint8_t bits[8];  // Highway writes up to 8 bytes
    hn::StoreMaskBits(d, hn::And(hn::Lt(along.least, zero), hn::Gt(along.most, zero)), bits);
    return bits[0] & 7u;
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#endif
