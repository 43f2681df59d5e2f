// Vectors of lanes. Read once for each instruction set, hence the guard of
// Highway's kind.
#if defined(RAYSWEEP_WIDE_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYSWEEP_WIDE_LANES_INL_H_
#undef RAYSWEEP_WIDE_LANES_INL_H_
#else
#define RAYSWEEP_WIDE_LANES_INL_H_
#endif

#include <hwy/highway.h>

#include <bit>

#include "tracer/wide/compactions.h"
#include "tracer/wide/geometry.h"

HWY_BEFORE_NAMESPACE();
namespace raysweep {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// As many lanes as the target's vectors have, but 8 at most.
inline constexpr int lane_count = HWY_MAX_BYTES >= 32 ? 8 : 4;
using Floats = hn::FixedTag<float, lane_count>;
using Words = hn::FixedTag<uint32_t, lane_count>;
using FloatLanes = hn::Vec<Floats>;
using WordLanes = hn::Vec<Words>;
using LaneMask = hn::Mask<Floats>;

/// Four numbers, by axis.
using Axes = hn::FixedTag<float, 4>;
using AxisWords = hn::FixedTag<uint32_t, 4>;
using AxisLanes = hn::Vec<Axes>;

/// Vec3 with the same operations in the same order, so that lanes round as scalars do: no fused operations.
/// `D` says how many lanes: of triangles that meet one ray, or of rays that meet one triangle.
template <class D>
struct Lanes3 {
  hn::Vec<D> x, y, z;
};

template <class D>
HWY_INLINE Lanes3<D> broadcast(D d, float x, float y, float z) {
  return {hn::Set(d, x), hn::Set(d, y), hn::Set(d, z)};
}
/// `stride` numbers lie between one row's lanes and the next one's.
template <class D>
HWY_INLINE Lanes3<D> load_rows(D d, const float* rows, size_t stride) {
  return {hn::Load(d, rows), hn::Load(d, rows + stride), hn::Load(d, rows + 2 * stride)};
}
template <class D>
HWY_INLINE Lanes3<D> minus(const Lanes3<D>& a, const Lanes3<D>& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
template <class D>
HWY_INLINE hn::Vec<D> dot(const Lanes3<D>& a, const Lanes3<D>& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
template <class D>
HWY_INLINE Lanes3<D> cross(const Lanes3<D>& a, const Lanes3<D>& b) {
  return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
          hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}

/// One bit a lane.
template <class Mask, class D = std::conditional_t<std::is_same_v<Mask, LaneMask>, Floats, Axes>>
HWY_INLINE uint32_t bits_of(Mask mask) {
  uint8_t bits[8];  // Highway writes up to 8 bytes
  hn::StoreMaskBits(D(), mask, bits);
  return bits[0];
}

/// The lowest bits, one a lane.
HWY_INLINE LaneMask mask_of(uint32_t bits) {
  uint8_t low[8] = {static_cast<uint8_t>(bits & ((1u << lane_count) - 1))};
  return hn::LoadMaskBits(Floats(), low);
}

/// `first` and the numbers behind it. Highway's Iota would put them together in memory.
template <class D>
HWY_INLINE hn::Vec<D> count_from(D d, uint32_t first) {
  return hn::Add(hn::Iota(d, 0), hn::Set(d, first));
}
HWY_INLINE WordLanes count_from(uint32_t first) { return count_from(Words(), first); }

/// Numbers of lanes packed `order_bits` each into a word, one number a lane; lanes above the lowest bits may
/// hold more.
HWY_INLINE WordLanes unpack(uint32_t packed) {
  const Words d;
  constexpr uint32_t bits = WideNode<lane_count>::order_bits;
  const WordLanes numbers = hn::Shr(hn::Set(d, packed), hn::Mul(hn::Iota(d, 0), hn::Set(d, bits)));
  // Permutations of 8 lanes look at no more than the lowest three bits; only Highway's own checks, where they
  // are on, look at all.
  if constexpr (lane_count == 8 && !HWY_IS_DEBUG_BUILD) return numbers;
  return hn::And(numbers, hn::Set(d, lane_count - 1));
}

HWY_INLINE FloatLanes permute(FloatLanes lanes, WordLanes numbers) {
  return hn::TableLookupLanes(lanes, hn::IndicesFromVec(Floats(), numbers));
}
HWY_INLINE WordLanes permute(WordLanes lanes, WordLanes numbers) {
  return hn::TableLookupLanes(lanes, hn::IndicesFromVec(Words(), numbers));
}

/// What lies `at` numbers behind each of `from`. Instructions that gather take longer.
template <class D>
HWY_INLINE hn::Vec<D> gather(D d, const float* const* from, size_t at) {
  // As integers, which compilers insert from memory.
  const auto four = [&](size_t i) HWY_ATTR {
    const AxisWords dw;
    const auto word = [&](size_t k) HWY_ATTR { return std::bit_cast<uint32_t>(from[i + k][at]); };
    return hn::InsertLane(hn::InsertLane(hn::InsertLane(hn::Set(dw, word(0)), 1, word(1)), 2, word(2)), 3,
                          word(3));
  };
  if constexpr (hn::MaxLanes(D()) == 4) {
    return hn::BitCast(d, four(0));
  } else {
    return hn::BitCast(d, hn::Combine(hn::RebindToUnsigned<D>(), four(4), four(0)));
  }
}

/// Eight numbers in memory, aligned as vectors are; each in all lanes.
class EachOfEight {
#if HWY_TARGET == HWY_AVX3
  // No more than two vectors can be loaded in a cycle, of which planes take enough; of registers for
  // permutations there are enough.
 public:
  HWY_INLINE explicit EachOfEight(const float* numbers) : numbers_(hn::Load(Floats(), numbers)) {}
  HWY_INLINE FloatLanes operator[](uint32_t i) const { return permute(numbers_, hn::Set(Words(), i)); }

 private:
  FloatLanes numbers_;
#else
 public:
  HWY_INLINE explicit EachOfEight(const float* numbers) : numbers_(numbers) {}
  HWY_INLINE FloatLanes operator[](uint32_t i) const { return hn::Set(Floats(), numbers_[i]); }

 private:
  const float* numbers_;
#endif
};

/// As many lanes as can be compacted at once.
inline constexpr int lanes_compacted = HWY_TARGET == HWY_AVX3 ? 16 : lane_count;

/// Moves the lanes of a mask to the front, in their order.
template <class D>
class CompactionOf {
  using DW = hn::RebindToUnsigned<D>;

 public:
#if HWY_TARGET == HWY_AVX3
  HWY_INLINE explicit CompactionOf(hn::Mask<D> mask) : mask_(mask) {}
  HWY_INLINE explicit CompactionOf(uint32_t bits) : mask_(mask_of(bits)) {}
  [[nodiscard]] HWY_INLINE uint32_t count() const { return static_cast<uint32_t>(hn::CountTrue(D(), mask_)); }
  HWY_INLINE hn::Vec<D> operator()(const hn::Vec<D>& lanes) const { return hn::Compress(lanes, mask_); }
  HWY_INLINE hn::Vec<DW> operator()(const hn::Vec<DW>& lanes) const {
    return hn::Compress(lanes, hn::RebindMask(DW(), mask_));
  }

 private:
  hn::Mask<D> mask_;
#else
  // Highway 1.0's own way, where there is no instruction, copies its table each time.
  HWY_INLINE explicit CompactionOf(LaneMask mask) : CompactionOf(bits_of(mask)) {}
  HWY_INLINE explicit CompactionOf(uint32_t bits) : bits_(bits), numbers_(unpack(compactions[bits_])) {}
  [[nodiscard]] HWY_INLINE uint32_t count() const { return static_cast<uint32_t>(hwy::PopCount(bits_)); }
  HWY_INLINE FloatLanes operator()(FloatLanes lanes) const { return permute(lanes, numbers_); }
  HWY_INLINE WordLanes operator()(WordLanes lanes) const { return permute(lanes, numbers_); }

 private:
  uint32_t bits_;
  WordLanes numbers_;
#endif
};
using Compaction = CompactionOf<Floats>;

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#endif
