// Rays made ready for kernels.
#if defined(RAYSWEEP_WIDE_RAY_SETUP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYSWEEP_WIDE_RAY_SETUP_INL_H_
#undef RAYSWEEP_WIDE_RAY_SETUP_INL_H_
#else
#define RAYSWEEP_WIDE_RAY_SETUP_INL_H_
#endif

#include "tracer/wide/accept-inl.h"
#include "tracer/wide/kernels.h"
#include "tracer/wide/stacks-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raysweep {
namespace HWY_NAMESPACE {

/// What a wide node's planes are compared with, for one ray: t = plane·reciprocal + offset.
///
/// One multiply-add a plane instead of `slab`'s two operations, and still no box is lost that `slab` keeps.
/// With u = 2⁻²⁴ and v = (plane − origin)·reciprocal, `slab` finds v(1 ± 2u). Here −origin·reciprocal is
/// rounded, and where nothing is fused the product is, too: together they are wrong by u(|origin| + |plane|)
/// in place of the plane, at most 2u|plane| + u|plane − origin|. Nodes' planes lie 4u|plane| further out than
/// those of `slab`, which is more than the first; what is left is v(1 ± 3u) on the safe side. Limits and far
/// distances are widened by 1 + 32u, more than all relative errors together, `slab`'s own widening included.
/// Needed: no overflow, hence the bounds of regular rays; along the axes of flat ones see `FlatAxes`.
struct alignas(64) Slot : StackPlace {
  // All that nodes ask for lies in one cache line, the first.
  uint8_t near_plane[3];  // bytes into a node
  uint8_t order;          // as well: of the octant's order
  uint32_t ray;
  uint32_t is_flat;
  uint32_t longest_axis;  // of the direction, for methods that shear
  float reciprocal[3], offset[3];
  float t;  // the nearest hit so far
  uint32_t id;
  float origin[4], direction[4];
  float shear[4];       // for methods that shear: how much the other axes are, and 1 by the longest one
  float far_offset[4];  // of flat rays, whose `offset` is for near planes
};
static_assert(sizeof(Slot) == 128);

/// At what distances a slot's ray hits the triangles of the block visited last, if they are accepted;
/// infinity: not hit. Not among what is read more often.
struct Distances {
  alignas(lane_count * sizeof(float)) float t[lane_count];

  HWY_INLINE static Distances& of(uint32_t slot_offset, char* distances) {
    return *reinterpret_cast<Distances*>(distances + slot_offset / (sizeof(Slot) / sizeof(Distances)));
  }
};

/// Four numbers of each lane's slot.
struct OfSlots {
  FloatLanes x, y, z, w;
  [[nodiscard]] HWY_INLINE Lanes3<Floats> xyz() const { return {x, y, z}; }
};
/// Those that begin at a field, or some rows of four behind it.
template <class Field>
HWY_INLINE OfSlots load_by_slot(const char* slots, const uint32_t* offsets, Field Slot::*field,
                                size_t rows_behind = 0) {
  const Floats d;
  const auto row = [&](size_t lane) HWY_ATTR {
    const auto at = [&](size_t i) HWY_ATTR {
      return hn::Load(Axes(), reinterpret_cast<const float*>(
                                  &(reinterpret_cast<const Slot*>(slots + offsets[i])->*field)) +
                                  4 * rows_behind);
    };
    if constexpr (lane_count == 4) {
      return at(lane);
    } else {
      return hn::Combine(Floats(), at(lane + 4), at(lane));
    }
  };
  const FloatLanes rows[4] = {row(0), row(1), row(2), row(3)};
  const auto xy_even = hn::InterleaveLower(d, rows[0], rows[2]),
             xy_odd = hn::InterleaveLower(d, rows[1], rows[3]),
             zw_even = hn::InterleaveUpper(d, rows[0], rows[2]),
             zw_odd = hn::InterleaveUpper(d, rows[1], rows[3]);
  return {hn::InterleaveLower(d, xy_even, xy_odd), hn::InterleaveUpper(d, xy_even, xy_odd),
          hn::InterleaveLower(d, zw_even, zw_odd), hn::InterleaveUpper(d, zw_even, zw_odd)};
}

/// Stores x, y, z and w of each lane there in its slot.
template <class D, class Field>
HWY_INLINE void store_by_slot(D d, char* slots, const uint32_t* offsets, Field Slot::*field,
                              size_t rows_behind, hn::Vec<D> x, hn::Vec<D> y, hn::Vec<D> z, hn::Vec<D> w) {
  const auto at = [&](size_t lane) HWY_ATTR {
    return reinterpret_cast<float*>(&(reinterpret_cast<Slot*>(slots + offsets[lane])->*field)) +
           4 * rows_behind;
  };
  const auto xz_low = hn::InterleaveLower(d, x, z), xz_high = hn::InterleaveUpper(d, x, z),
             yw_low = hn::InterleaveLower(d, y, w), yw_high = hn::InterleaveUpper(d, y, w);
  const hn::Vec<D> rows[4] = {hn::InterleaveLower(d, xz_low, yw_low), hn::InterleaveUpper(d, xz_low, yw_low),
                              hn::InterleaveLower(d, xz_high, yw_high),
                              hn::InterleaveUpper(d, xz_high, yw_high)};
  for (size_t i = 0; i < 4; ++i) {
    if constexpr (hn::MaxLanes(D()) == 4) {
      hn::Store(rows[i], Axes(), at(i));
    } else {
      hn::Store(hn::LowerHalf(Axes(), rows[i]), Axes(), at(i));
      hn::Store(hn::UpperHalf(Axes(), rows[i]), Axes(), at(i + 4));
    }
  }
}

/// The ray of a slot for what is computed outside of lanes.
struct RayOfSlot {
  Ray<float> ray;
  SlabRay<float> slab_ray;

  HWY_INLINE explicit RayOfSlot(const Slot& s)
      : ray{{s.origin[0], s.origin[1], s.origin[2]}, {s.direction[0], s.direction[1], s.direction[2]}},
        slab_ray(s.is_flat != 0 ? SlabRay<float>(ray)
                                : SlabRay<float>(ray, {s.reciprocal[0], s.reciprocal[1], s.reciprocal[2]})) {}
};

inline constexpr float offset_error = 4 * unit_roundoff<float>, smallest = 0x1p-120f, widening = 1 + 0x1p-19f;
inline constexpr float regular_high = 0x1p60f, regular_low = 0x1p-60f;

/// Children of the wide node at `node` that the ray of a slot meets.
template <bool is_flat>
HWY_INLINE Meeting meet_of_ray(const Slot& slot, const char* node) {
  const Floats d;
  const EachOfEight of_slot(slot.reciprocal);
  const FloatLanes by[3] = {of_slot[0], of_slot[1], of_slot[2]},
                   from[3] = {of_slot[3], of_slot[4], of_slot[5]};
  const auto meet = [&](size_t at, int axis, FloatLanes offset) HWY_ATTR {
    return hn::MulAdd(hn::Load(Floats(), reinterpret_cast<const float*>(node + at)), by[axis], offset);
  };
  const auto meet_near = [&](int axis) HWY_ATTR { return meet(slot.near_plane[axis], axis, from[axis]); };
  const auto meet_far = [&](int axis) HWY_ATTR {
    // Rows of lower and upper planes take turns.
    constexpr size_t row = lane_count * sizeof(float);
    const size_t both = (4 * static_cast<size_t>(axis) + 1) * row;
    return meet(both - slot.near_plane[axis], axis,
                is_flat ? hn::Set(Floats(), slot.far_offset[axis]) : from[axis]);
  };
  const FloatLanes enter = hn::Max(hn::Max(meet_near(0), meet_near(1)), hn::Max(meet_near(2), hn::Zero(d)));
  const FloatLanes leave = hn::Min(meet_far(0), hn::Min(meet_far(1), meet_far(2)));
  const FloatLanes limit = hn::Mul(hn::Min(leave, hn::Set(d, slot.t)), hn::Set(d, widening));
  return {enter, hn::Le(enter, limit)};
}

/// Lets each of a vector of rays begin with nothing hit.
template <class D>
HWY_INLINE void begin_hits(D d, const RayBatch& rays, HitBatch& hits, size_t first) {
  const hn::RebindToUnsigned<D> dw;
  hn::Store(hn::Load(d, rays.t_max.data() + first), d, hits.t.data() + first);
  hn::Store(hn::Set(dw, no_hit_id), dw, hits.id.data() + first);
}

/// Rays that do not move, or hardly, along some axis: those along an axis of the world, above all. There the
/// direction's reciprocal would overflow. Instead of it stands one of 2¹⁰⁰ over the scene's size S, and
/// offsets are moved by 2⁸², so that a ray is inside the planes until t = 2⁸¹ if it begins between them or up
/// to 2⁻¹⁸S beside them, and never if it begins 2⁻¹⁷S away: products are 2¹⁰¹ at most; their roundings, and
/// what nodes' planes lie further out, 2⁸⁰ together. What is asked of such rays: that they leave the scene
/// before 2⁸⁰, by an axis that is not flat, and move by 2⁻²⁰S at most till then along those that are. Hits
/// are accepted one by one, by `slab` itself.
class FlatAxes {
 public:
  HWY_INLINE explicit FlatAxes(const Box<float>& bounds)
      : size_(std::max({max_abs(bounds.lower()), max_abs(bounds.upper()), 0x1p-26f})) {}

  [[nodiscard]] HWY_INLINE float reciprocal() const { return 0x1p100f / size_; }
  static constexpr float way = 0x1p82f;
  /// How far beside the scene a ray may begin.
  [[nodiscard]] HWY_INLINE float beside() const { return 0x1p-17f * size_; }
  /// Whether rays are as asked that leave the scene at `leave` and move by `along` at most in 1 of t.
  [[nodiscard]] HWY_INLINE LaneMask are_manageable(FloatLanes leave, FloatLanes along) const {
    const Floats d;
    return hn::Or(hn::Lt(leave, hn::Zero(d)),
                  hn::And(hn::Le(leave, hn::Set(d, 0x1p80f)),
                          hn::Le(hn::Mul(leave, along), hn::Set(d, 0x1p-20f * size_))));
  }

 private:
  const float size_;
};

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#endif
