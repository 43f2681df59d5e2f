// Few rays that meet a block, a triangle a lane: two at once where vectors have room for twice its lanes.
#if defined(RAYSWEEP_WIDE_SPREAD_RAYS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYSWEEP_WIDE_SPREAD_RAYS_INL_H_
#undef RAYSWEEP_WIDE_SPREAD_RAYS_INL_H_
#else
#define RAYSWEEP_WIDE_SPREAD_RAYS_INL_H_
#endif

#include "tracer/wide/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raysweep {
namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_AVX3

inline constexpr uint32_t rays_a_test = 2;

/// Two rays of a packet, named by its offset plus their numbers.
class SpreadRays {
 public:
  using Tag = hn::FixedTag<float, 2 * lane_count>;

  HWY_INLINE explicit SpreadRays(const uint32_t* rays)
      : numbers_(hn::Combine(Twice(), hn::Set(Words(), rays[1]), hn::Set(Words(), rays[0]))) {}

  /// A lane of each row, for every triangle. Permutations look at the lowest bits alone.
  HWY_INLINE Lanes3<Tag> of(const PacketRows& rows, const uint32_t (&axes)[3]) const {
    return {of(rows[axes[0]]), of(rows[axes[1]]), of(rows[axes[2]])};
  }
  HWY_INLINE hn::Vec<Tag> of(const float* row) const {
    return hn::TableLookupLanes(hn::Load(Tag(), row), hn::Indices512<float>{numbers_.raw});
  }

  template <class Block>
  HWY_INLINE static Corners<Tag> corners_of(const Block& block, const uint32_t (&axes)[3]) {
    const auto twice = [](const float* row)
                           HWY_ATTR { return hn::Vec<Tag>{_mm512_broadcast_f32x8(_mm256_load_ps(row))}; };
    const auto corner = [&](size_t row) HWY_ATTR {
      return Lanes3<Tag>{twice(block.corners[row + axes[0]]), twice(block.corners[row + axes[1]]),
                         twice(block.corners[row + axes[2]])};
    };
    return {corner(0), corner(3), corner(6)};
  }

  /// Lists those of `rays` that meet something, and at what distances; how many.
  HWY_INLINE static uint32_t list(const uint32_t* rays, hn::Mask<Tag> hit, hn::Vec<Tag> t, uint32_t* met,
                                  float* distances) {
    const uint32_t bits = hit.raw, is_first = (bits & 0xff) != 0 ? 1 : 0, is_second = bits >> 8 != 0 ? 1 : 0;
    hn::Store(hn::LowerHalf(Floats(), t), Floats(), distances);
    hn::Store(hn::UpperHalf(Floats(), t), Floats(), distances + is_first * lane_count);
    met[0] = rays[0];
    met[is_first] = rays[1];
    return is_first + (is_second & static_cast<uint32_t>(rays[0] != rays[1]));
  }

 private:
  using Twice = hn::FixedTag<uint32_t, 2 * lane_count>;

  hn::Vec<Twice> numbers_;
};

#else

inline constexpr uint32_t rays_a_test = 1;

class SpreadRays {
 public:
  using Tag = Floats;

  HWY_INLINE explicit SpreadRays(const uint32_t* rays) : number_(rays[0] % packet_size) {}

  HWY_INLINE Lanes3<Tag> of(const PacketRows& rows, const uint32_t (&axes)[3]) const {
    return broadcast(Tag(), rows[axes[0]][number_], rows[axes[1]][number_], rows[axes[2]][number_]);
  }

  HWY_INLINE hn::Vec<Tag> of(const float* row) const { return hn::Set(Tag(), row[number_]); }

  template <class Block>
  HWY_INLINE static Corners<Tag> corners_of(const Block& block, const uint32_t (&axes)[3]) {
    return HWY_NAMESPACE::corners_of(block, axes);
  }

  HWY_INLINE static uint32_t list(const uint32_t* rays, hn::Mask<Tag> hit, hn::Vec<Tag> t, uint32_t* met,
                                  float* distances) {
    hn::Store(t, Tag(), distances);
    met[0] = rays[0];
    return hn::AllFalse(Tag(), hit) ? 0 : 1;
  }

 private:
  size_t number_;
};

#endif

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#endif
