// Single rays loaded, as many at once as vectors have lanes.
#if defined(RAYSWEEP_WIDE_RAY_LOADER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYSWEEP_WIDE_RAY_LOADER_INL_H_
#undef RAYSWEEP_WIDE_RAY_LOADER_INL_H_
#else
#define RAYSWEEP_WIDE_RAY_LOADER_INL_H_
#endif

#include "tracer/wide/ray_setup-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raysweep {
namespace HWY_NAMESPACE {

/// Chooses rays of a batch that may meet something, from the groups of `packet_size` that `scratch` lists,
/// and makes them ready: first all but the flat ones, whose groups it lists, then these.
template <class Method, bool any>
class RayLoader {
 public:
  HWY_INLINE RayLoader(const WideGeometry<Method, lane_count>& geometry, const RayBatch& rays, HitBatch& hits,
                       KernelScratch& scratch, bool takes_flat)
      : rays_(rays),
        hits_(hits),
        bounds_(geometry.tree.bounds),
        flat_axes_(bounds_),
        takes_flat_(takes_flat),
        begins_hits_(!takes_flat && geometry.begins_hits()),
        groups_(takes_flat ? scratch.flat_groups : scratch.groups),
        flat_groups_(scratch.flat_groups),
        left_over_(scratch.left_over) {}

  /// Of all groups, of which only the last may lack some.
  HWY_INLINE size_t ray_count() const {
    if (groups_.empty()) return 0;
    return (groups_.size() - 1) * packet_size + std::min(packet_size, rays_.size - groups_.back());
  }

  /// Whether some rays were not looked at.
  [[nodiscard]] HWY_INLINE bool has_next() const { return next_ < groups_.size() * packet_size; }

  /// Looks at the next `lane_count` rays, and loads those that may meet something into the first of as many
  /// slots, whose others are lost; how many. Rays that miss the box around everything are done: most rays of
  /// an open scene, and so many at a time cost little.
  HWY_INLINE uint32_t load_next(char* slots, const uint32_t* offsets) {
    const size_t first = groups_[next_ / packet_size] + next_ % packet_size;
    next_ += lane_count;
    if (first >= rays_.size) return 0;
    if (begins_hits_) begin_hits(Floats(), rays_, hits_, first);
    const Rays rays = load(first);
    const LaneMask chosen = choose(rays, first);
    if (hn::AllFalse(Floats(), chosen)) return 0;
    const Compaction keep(chosen);
    set_slots(rays, keep, slots, offsets);
    return keep.count();
  }

 private:
  /// What a ray's way to a plane across an axis is computed from: plane·reciprocal + offset.
  struct Along {
    FloatLanes reciprocal, offset;
    LaneMask is_flat;

    /// How far offsets are to be moved to the safe side.
    [[nodiscard]] HWY_INLINE FloatLanes way() const {
      return hn::IfThenElseZero(is_flat, hn::Set(Floats(), FlatAxes::way));
    }
  };
  struct Rays {
    Lanes3<Floats> origin, direction;
    Along x, y, z;
    FloatLanes t;
    WordLanes id, number;

    [[nodiscard]] HWY_INLINE LaneMask are_flat() const {
      return hn::Or(x.is_flat, hn::Or(y.is_flat, z.is_flat));
    }
  };
  struct Meets {
    LaneMask some, is_regular;
  };

  [[nodiscard]] HWY_INLINE Rays load(size_t first) const {
    const Lanes3<Floats> origin = load_at(rays_.origin_x, rays_.origin_y, rays_.origin_z, first),
                         direction = load_at(rays_.direction_x, rays_.direction_y, rays_.direction_z, first);
    return {origin,
            direction,
            along(origin.x, direction.x),
            along(origin.y, direction.y),
            along(origin.z, direction.z),
            hn::Load(Floats(), hits_.t.data() + first),
            hn::Load(Words(), hits_.id.data() + first),
            count_from(static_cast<uint32_t>(first))};
  }

  /// Those that may meet something and are to be taken. Rays that are not regular are left over.
  [[nodiscard]] HWY_INLINE LaneMask choose(const Rays& rays, size_t first) {
    const Floats d;
    const Words dw;
    LaneMask is_there =
        hn::RebindMask(d, hn::Lt(rays.number, hn::Set(dw, static_cast<uint32_t>(rays_.size))));
    // What something hides already is done.
    if constexpr (any)
      is_there = hn::And(is_there, hn::RebindMask(d, hn::Eq(rays.id, hn::Set(dw, no_hit_id))));
    const Meets meets = meets_scene(rays);
    const LaneMask due = hn::And(hn::And(meets.some, meets.is_regular), is_there);
    const LaneMask flat = hn::And(due, rays.are_flat());
    if (takes_flat_) return flat;
    for (uint32_t left = bits_of(hn::AndNot(meets.is_regular, is_there)); left != 0; left &= left - 1)
      left_over_.push_back(static_cast<uint32_t>(first + hwy::Num0BitsBelowLS1Bit_Nonzero32(left)));
    if (!hn::AllFalse(d, flat)) {
      const auto group = static_cast<uint32_t>(first - first % packet_size);
      if (flat_groups_.empty() || flat_groups_.back() != group) flat_groups_.push_back(group);
    }
    return hn::AndNot(flat, due);
  }

  HWY_INLINE void set_slots(const Rays& rays, const Compaction& keep, char* slots,
                            const uint32_t* offsets) const {
    const Floats d;
    const Words dw;
    const auto set = [&](auto field, size_t rows, FloatLanes x, FloatLanes y, FloatLanes z, FloatLanes more)
                         HWY_ATTR { store_by_slot(Floats(), slots, offsets, field, rows, x, y, z, more); };
    const auto number = [](auto v) HWY_ATTR { return hn::BitCast(Floats(), v); };
    const auto kept = [&keep](const Lanes3<Floats>& v) HWY_ATTR {
      return Lanes3<Floats>{keep(v.x), keep(v.y), keep(v.z)};
    };
    const Along &x = rays.x, &y = rays.y, &z = rays.z;
    const Lanes3<Floats> origin = kept(rays.origin), direction = kept(rays.direction),
                         reciprocal = kept({x.reciprocal, y.reciprocal, z.reciprocal});
    Lanes3<Floats> offset{x.offset, y.offset, z.offset};
    if (takes_flat_) {
      const Lanes3<Floats> far =
          kept({hn::Add(x.offset, x.way()), hn::Add(y.offset, y.way()), hn::Add(z.offset, z.way())});
      set(&Slot::far_offset, 0, far.x, far.y, far.z, far.x);
      offset = {hn::Sub(x.offset, x.way()), hn::Sub(y.offset, y.way()), hn::Sub(z.offset, z.way())};
    }
    offset = kept(offset);
    FloatLanes longest_axis = hn::Zero(d);
    if constexpr (shears<Method>) {
      const LongestAxis<Floats> axis(direction);
      const FloatLanes which = axis.number(), inverse = hn::Div(hn::Set(d, 1.0f), axis.of(direction));
      const auto shear = [&](FloatLanes v, float number_of) HWY_ATTR {
        return hn::IfThenElse(hn::Eq(which, hn::Set(Floats(), number_of)), inverse, hn::Mul(v, inverse));
      };
      set(&Slot::shear, 0, shear(direction.x, 0), shear(direction.y, 1), shear(direction.z, 2), inverse);
      longest_axis = number(hn::ConvertTo(hn::RebindToSigned<Floats>(), which));
    }
    const auto falls = [](FloatLanes v) HWY_ATTR { return hn::ShiftRight<31>(hn::BitCast(Words(), v)); };
    const WordLanes falls_x = falls(direction.x), falls_y = falls(direction.y), falls_z = falls(direction.z),
                    octant = hn::Add(falls_x, hn::Add(hn::ShiftLeft<1>(falls_y), hn::ShiftLeft<2>(falls_z)));
    // A byte each of one number.
    constexpr int row_bits = lane_count == 8 ? 5 : 4;
    static_assert(lane_count * sizeof(float) == 1u << row_bits);
    constexpr uint32_t orders = offsetof(WideNode<lane_count>, far_to_near),
                       rows_down = (2u << (row_bits + 8)) | (4u << (row_bits + 16)) | (orders << 24);
    static_assert(orders + 7 * sizeof(uint32_t) < 256);
    const WordLanes planes = hn::Add(
        hn::Add(hn::Set(dw, rows_down), hn::ShiftLeft<26>(octant)),
        hn::Add(hn::ShiftLeft<row_bits>(falls_x),
                hn::Add(hn::ShiftLeft<row_bits + 8>(falls_y), hn::ShiftLeft<row_bits + 16>(falls_z))));
    set(&Slot::near_plane, 0, number(planes), number(keep(rays.number)),
        keep(hn::VecFromMask(d, rays.are_flat())), longest_axis);
    set(&Slot::reciprocal, 0, reciprocal.x, reciprocal.y, reciprocal.z, offset.x);
    set(&Slot::reciprocal, 1, offset.y, offset.z, keep(rays.t), number(keep(rays.id)));
    set(&Slot::origin, 0, origin.x, origin.y, origin.z, origin.x);
    set(&Slot::direction, 0, direction.x, direction.y, direction.z, direction.x);
  }

  [[nodiscard]] HWY_INLINE Along along(FloatLanes from, FloatLanes direction) const {
    const Floats d;
    const LaneMask is_flat = hn::Lt(hn::Abs(direction), hn::Set(d, regular_low));
    const FloatLanes reciprocal =
        hn::IfThenElse(is_flat, hn::CopySign(hn::Set(d, flat_axes_.reciprocal()), direction),
                       hn::Div(hn::Set(d, 1.0f), direction));
    return {reciprocal, hn::Neg(hn::Mul(from, reciprocal)), is_flat};
  }

  /// Which rays meet the box around everything, whose planes lie further out as nodes' do.
  [[nodiscard]] HWY_INLINE Meets meets_scene(const Rays& rays) const {
    const Floats d;
    FloatLanes enter = hn::Zero(d), leave = rays.t, flat_way = hn::Zero(d);
    const FloatLanes beside = hn::Set(d, flat_axes_.beside());
    LaneMask is_regular = hn::Eq(enter, enter), is_beside = hn::Ne(enter, enter);
    const auto cut = [&](FloatLanes from, FloatLanes direction_of, const Along& way, float lower,
                         float upper) HWY_ATTR {
      const FloatLanes size = hn::Abs(direction_of), high = hn::Set(Floats(), regular_high);
      is_regular = hn::And(is_regular, hn::And(hn::Le(size, high), hn::Le(hn::Abs(from), high)));
      flat_way = hn::Max(flat_way, hn::IfThenElseZero(way.is_flat, size));
      const LaneMask is_outside = hn::Or(hn::Lt(from, hn::Sub(hn::Set(Floats(), lower), beside)),
                                         hn::Gt(from, hn::Add(hn::Set(Floats(), upper), beside)));
      is_beside = hn::Or(is_beside, hn::And(way.is_flat, is_outside));
      const FloatLanes a = hn::Mul(hn::Set(Floats(), lower), way.reciprocal),
                       b = hn::Mul(hn::Set(Floats(), upper), way.reciprocal);
      const FloatLanes first = hn::Add(hn::Min(a, b), way.offset), last = hn::Add(hn::Max(a, b), way.offset);
      enter = hn::IfThenElse(way.is_flat, enter, hn::Max(enter, first));
      leave = hn::IfThenElse(way.is_flat, leave, hn::Min(leave, last));
    };
    const Lanes3<Floats>&from = rays.origin, &along = rays.direction;
    cut(from.x, along.x, rays.x, bounds_.lower().x, bounds_.upper().x);
    cut(from.y, along.y, rays.y, bounds_.lower().y, bounds_.upper().y);
    cut(from.z, along.z, rays.z, bounds_.lower().z, bounds_.upper().z);
    is_regular =
        hn::AndNot(hn::AndNot(flat_axes_.are_manageable(leave, flat_way), rays.are_flat()), is_regular);
    return {hn::AndNot(is_beside, hn::Le(enter, hn::Mul(leave, hn::Set(d, widening)))), is_regular};
  }

  HWY_INLINE static Lanes3<Floats> load_at(const LaneArray<float>& x, const LaneArray<float>& y,
                                           const LaneArray<float>& z, size_t first) {
    const Floats d;
    return {hn::Load(d, x.data() + first), hn::Load(d, y.data() + first), hn::Load(d, z.data() + first)};
  }

  const RayBatch& rays_;
  HitBatch& hits_;
  const Box<float>& bounds_;
  const FlatAxes flat_axes_;
  const bool takes_flat_, begins_hits_;
  const std::vector<uint32_t>& groups_;
  std::vector<uint32_t>& flat_groups_;
  std::vector<uint32_t>& left_over_;
  size_t next_ = 0;  // number, in all groups, of the first ray not looked at
};

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#endif
