// Rays made ready for kernels.
#if defined(RAYSWEEP_WIDE_RAY_SETUP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYSWEEP_WIDE_RAY_SETUP_INL_H_
#undef RAYSWEEP_WIDE_RAY_SETUP_INL_H_
#else
#define RAYSWEEP_WIDE_RAY_SETUP_INL_H_
#endif

#include <bit>

#include "tracer/wide/accept-inl.h"
#include "tracer/wide/kernels.h"
#include "tracer/wide/stacks-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raysweep {
namespace HWY_NAMESPACE {

/// What a wide node's planes are compared with, for one ray: t = plane·reciprocal + offset.
///
/// One multiply-add a plane instead of `slab`'s two operations, and still no box is lost that `slab` keeps.
/// With u = 2⁻²⁴ and v = (plane − origin)·reciprocal, `slab` finds v(1 ± 2u). Here −origin·reciprocal is c(1
/// ± u), moving it costs another u|c|, and where nothing is fused the product adds u(|v| + |c|): 3u|c|
/// together. It is moved by 4u|c|, down for near planes and up for far ones; what is left is v(1 ± 2u) on the
/// safe side. Limits and far distances are widened by 1 + 32u, more than all relative errors together,
/// `slab`'s own widening included. `smallest` outweighs underflow. Needed: no overflow, hence the bounds of
/// regular rays; along the axes of flat ones see `FlatAxes`.
struct alignas(64) Slot : StackPlace {
  // What nodes and triangles are compared with lies in two cache lines.
  float reciprocal[4], near_offset[4], far_offset[4];
  uint32_t near_plane[4];  // bytes into a node; [3]: of the octant's order
  float limit;             // `t`, widened
  float t;                 // the nearest hit so far
  uint32_t id;
  uint32_t ray;
  alignas(16) float origin[4], direction[4];
  uint32_t is_flat;
  uint32_t longest_axis;  // of the direction, and
  float shear[3];         // how much the others are sheared, and 1 by its own: for methods that shear
  alignas(32) float distances[8];  // at which the block's triangles are hit, if accepted; infinity: not hit

  HWY_INLINE void set_shear() {
    const float x = std::abs(direction[0]), y = std::abs(direction[1]), z = std::abs(direction[2]);
    // As raysweep::longest_axis, but which one it is nobody can guess: numbers, not branches.
    const uint32_t is_x = (x > y ? 1u : 0u) & (x > z ? 1u : 0u), is_y = y > z ? 1u : 0u;
    const uint32_t longest = (1 - is_x) * (2 - is_y);
    const float inverse = 1 / direction[longest];
    for (size_t axis = 0; axis < 3; ++axis) shear[axis] = direction[axis] * inverse;
    shear[longest] = inverse;
    longest_axis = longest;
  }
};

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

/// Rays that do not move, or hardly, along some axis: those along an axis of the world, above all. There the
/// direction's reciprocal would overflow. Instead of it stands one of 2¹⁰⁰ over the scene's size S, and
/// offsets are moved by 2⁸², so that a ray is inside the planes until t = 2⁸¹ if it begins between them or up
/// to 2⁻¹⁸S beside them, and never if it begins 2⁻¹⁷S away: products are 2¹⁰¹ at most, and their roundings
/// 2⁸⁰ together. What is asked of such rays: that they leave the scene before 2⁸⁰, by an axis that is not
/// flat, and move by 2⁻²⁰S at most till then along those that are. Hits are accepted one by one, by `slab`
/// itself.
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

/// Rays looked at before the next ones begin: so many that the loop's end is rare.
inline constexpr size_t chosen_at_once = 256;

/// Chooses rays of a batch that may meet something, from the groups of `packet_size` that `scratch` lists,
/// and makes them ready.
template <bool any>
class Chooser {
 public:
  HWY_INLINE Chooser(const RayBatch& rays, const HitBatch& hits, const Box<float>& bounds,
                     KernelScratch& scratch)
      : rays_(rays),
        hits_(hits),
        bounds_(bounds),
        flat_axes_(bounds),
        groups_(scratch.groups),
        left_over_(scratch.left_over) {}

  /// `memory` has room for `chosen_at_once + 2 · packet_size` numbers.
  HWY_INLINE void work_in(uint32_t* memory) { pending_ = memory; }

  /// Of all groups, of which only the last may lack some.
  HWY_INLINE size_t ray_count() const {
    if (groups_.empty()) return 0;
    return (groups_.size() - 1) * packet_size + std::min(packet_size, rays_.size - groups_.back());
  }

  /// Whether a ray is left that may meet something. Those that miss the box around everything are done: most
  /// rays of an open scene, and so many at a time cost little.
  HWY_INLINE bool has_next() {
    while (next_pending_ == pending_count_ && next_group_ < groups_.size()) {
      next_pending_ = pending_count_ = 0;
      while (next_group_ < groups_.size() && pending_count_ < chosen_at_once) {
        const size_t first = groups_[next_group_++], end = std::min(first + packet_size, rays_.size);
        for (size_t i = first; i < end; i += lane_count) choose(i);
      }
    }
    return next_pending_ < pending_count_;
  }

  /// Loads the next of them.
  HWY_INLINE void load_next(Slot& slot) {
    const hn::FixedTag<float, 4> d;
    const hn::FixedTag<uint32_t, 4> du;
    const size_t i = pending_[next_pending_++];
    auto origin = hn::Zero(d), direction = hn::Set(d, 1.0f);
    origin = hn::InsertLane(origin, 0, rays_.origin_x[i]);
    origin = hn::InsertLane(origin, 1, rays_.origin_y[i]);
    origin = hn::InsertLane(origin, 2, rays_.origin_z[i]);
    direction = hn::InsertLane(direction, 0, rays_.direction_x[i]);
    direction = hn::InsertLane(direction, 1, rays_.direction_y[i]);
    direction = hn::InsertLane(direction, 2, rays_.direction_z[i]);
    const auto is_flat = hn::Lt(hn::Abs(direction), hn::Set(d, regular_low));
    const auto flat = hn::CopySign(hn::Set(d, flat_axes_.reciprocal()), direction);
    const auto reciprocal = hn::IfThenElse(is_flat, flat, hn::Div(hn::Set(d, 1.0f), direction));
    const auto c = hn::Neg(hn::Mul(origin, reciprocal));
    const auto error =
        hn::IfThenElse(is_flat, hn::Set(d, FlatAxes::way),
                       hn::Add(hn::Mul(hn::Abs(c), hn::Set(d, offset_error)), hn::Set(d, smallest)));
    hn::Store(reciprocal, d, slot.reciprocal);
    hn::Store(hn::Sub(c, error), d, slot.near_offset);
    hn::Store(hn::Add(c, error), d, slot.far_offset);
    hn::Store(origin, d, slot.origin);
    hn::Store(direction, d, slot.direction);
    slot.is_flat = hn::AllFalse(d, is_flat) ? 0 : 1;
    constexpr uint32_t row = lane_count * sizeof(float);
    alignas(16) static constexpr uint32_t lower[4] = {0, 2 * row, 4 * row, 0};
    const auto sign = hn::ShiftRight<31>(hn::BitCast(du, direction));
    hn::Store(hn::Add(hn::Mul(sign, hn::Set(du, row)), hn::Load(du, lower)), du, slot.near_plane);
    const auto sign_of = [](float x) { return std::bit_cast<uint32_t>(x) >> 31; };
    const uint32_t octant =
        sign_of(rays_.direction_x[i]) + 2 * sign_of(rays_.direction_y[i]) + 4 * sign_of(rays_.direction_z[i]);
    slot.near_plane[3] = static_cast<uint32_t>(offsetof(WideNode<lane_count>, far_to_near)) + octant * 4;
    slot.ray = static_cast<uint32_t>(i);
    slot.t = hits_.t[i];
    slot.id = hits_.id[i];
    slot.limit = slot.t * widening;
  }

 private:
  /// Of the rays in lanes from `first` on, lists those that meet the box around everything. As in Slot,
  /// offsets are moved to the safe side, here by 8u|c|: product and sum are rounded apart.
  HWY_INLINE void choose(size_t first) {
    const Floats d;
    const Words dw;
    const Lanes3<Floats> origin = load_at(rays_.origin_x, rays_.origin_y, rays_.origin_z, first);
    const Lanes3<Floats> direction = load_at(rays_.direction_x, rays_.direction_y, rays_.direction_z, first);
    FloatLanes enter = hn::Zero(d), leave = hn::Load(d, hits_.t.data() + first);
    const FloatLanes beside = hn::Set(d, flat_axes_.beside());
    FloatLanes flat_along = hn::Zero(d);
    LaneMask is_regular = hn::Eq(enter, enter), is_flat = hn::Ne(enter, enter), is_beside = is_flat;
    const auto cut = [&](const FloatLanes& from, const FloatLanes& along, float lower, float upper) HWY_ATTR {
      const FloatLanes size = hn::Abs(along), high = hn::Set(Floats(), regular_high);
      is_regular = hn::And(is_regular, hn::And(hn::Le(size, high), hn::Le(hn::Abs(from), high)));
      const LaneMask is_flat_here = hn::Lt(size, hn::Set(Floats(), regular_low));
      is_flat = hn::Or(is_flat, is_flat_here);
      flat_along = hn::Max(flat_along, hn::IfThenElseZero(is_flat_here, size));
      const LaneMask is_outside = hn::Or(hn::Lt(from, hn::Sub(hn::Set(Floats(), lower), beside)),
                                         hn::Gt(from, hn::Add(hn::Set(Floats(), upper), beside)));
      is_beside = hn::Or(is_beside, hn::And(is_flat_here, is_outside));
      const FloatLanes reciprocal = hn::Div(hn::Set(Floats(), 1.0f), along);
      const FloatLanes c = hn::Neg(hn::Mul(from, reciprocal));
      const FloatLanes error =
          hn::MulAdd(hn::Abs(c), hn::Set(Floats(), offset_error), hn::Set(Floats(), smallest));
      const FloatLanes a = hn::Mul(hn::Set(Floats(), lower), reciprocal),
                       b = hn::Mul(hn::Set(Floats(), upper), reciprocal);
      const FloatLanes slack = hn::Add(error, error);
      enter = hn::IfThenElse(is_flat_here, enter, hn::Max(enter, hn::Sub(hn::Add(hn::Min(a, b), c), slack)));
      leave = hn::IfThenElse(is_flat_here, leave, hn::Min(leave, hn::Add(hn::Add(hn::Max(a, b), c), slack)));
    };
    cut(origin.x, direction.x, bounds_.lower().x, bounds_.upper().x);
    cut(origin.y, direction.y, bounds_.lower().y, bounds_.upper().y);
    cut(origin.z, direction.z, bounds_.lower().z, bounds_.upper().z);
    LaneMask is_there =
        hn::RebindMask(d, hn::Lt(hn::Iota(dw, 0), hn::Set(dw, static_cast<uint32_t>(rays_.size - first))));
    // What something hides already is done.
    if constexpr (any) {
      const WordLanes id = hn::Load(dw, hits_.id.data() + first);
      is_there = hn::And(is_there, hn::RebindMask(d, hn::Eq(id, hn::Set(dw, no_hit_id))));
    }
    is_regular = hn::AndNot(hn::AndNot(flat_axes_.are_manageable(leave, flat_along), is_flat), is_regular);
    const LaneMask meets = hn::AndNot(is_beside, hn::Le(enter, hn::Mul(leave, hn::Set(d, widening))));
    const Compaction chosen(hn::And(hn::And(meets, is_regular), is_there));
    hn::StoreU(chosen(count_from(static_cast<uint32_t>(first))), dw, pending_ + pending_count_);
    pending_count_ += chosen.count();
    for (uint32_t left = bits_of(hn::AndNot(is_regular, is_there)); left != 0; left &= left - 1)
      left_over_.push_back(static_cast<uint32_t>(first + hwy::Num0BitsBelowLS1Bit_Nonzero32(left)));
  }

  HWY_INLINE static Lanes3<Floats> load_at(const LaneArray<float>& x, const LaneArray<float>& y,
                                           const LaneArray<float>& z, size_t first) {
    const Floats d;
    return {hn::Load(d, x.data() + first), hn::Load(d, y.data() + first), hn::Load(d, z.data() + first)};
  }

  const RayBatch& rays_;
  const HitBatch& hits_;
  const Box<float>& bounds_;
  const FlatAxes flat_axes_;
  const std::vector<uint32_t>& groups_;
  std::vector<uint32_t>& left_over_;
  uint32_t* pending_ = nullptr;  // rays to be begun
  size_t next_group_ = 0;        // the first one not looked at
  uint32_t next_pending_ = 0, pending_count_ = 0;
};

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#endif
