// Which of the hits that methods find count, and where: what Primitives does, in lanes.
#if defined(RAYSWEEP_WIDE_ACCEPT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYSWEEP_WIDE_ACCEPT_INL_H_
#undef RAYSWEEP_WIDE_ACCEPT_INL_H_
#else
#define RAYSWEEP_WIDE_ACCEPT_INL_H_
#endif

#include "tracer/accel/primitives.h"
#include "tracer/wide/methods-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raysweep {
namespace HWY_NAMESPACE {

/// Boxes around triangles as `Primitives` keeps them: `padded`.
template <class D>
struct LaneBoxes {
  Lanes3<D> lower, upper;
};

template <class D>
HWY_INLINE LaneBoxes<D> boxes_of(D d, const Corners<D>& t) {
  const auto least = [](auto a, auto b, auto c) HWY_ATTR { return hn::Min(hn::Min(a, b), c); };
  const auto most = [](auto a, auto b, auto c) HWY_ATTR { return hn::Max(hn::Max(a, b), c); };
  const Lanes3<D> lower{least(t.a.x, t.b.x, t.c.x), least(t.a.y, t.b.y, t.c.y), least(t.a.z, t.b.z, t.c.z)},
      upper{most(t.a.x, t.b.x, t.c.x), most(t.a.y, t.b.y, t.c.y), most(t.a.z, t.b.z, t.c.z)};
  const auto size = hn::Max(most(hn::Abs(lower.x), hn::Abs(lower.y), hn::Abs(lower.z)),
                            most(hn::Abs(upper.x), hn::Abs(upper.y), hn::Abs(upper.z)));
  const auto by = hn::Mul(size, hn::Set(d, box_padding<float>));
  return {{hn::Sub(lower.x, by), hn::Sub(lower.y, by), hn::Sub(lower.z, by)},
          {hn::Add(upper.x, by), hn::Add(upper.y, by), hn::Add(upper.z, by)}};
}

/// Distances at which lanes count as hit, and which do.
template <class D>
struct AcceptedHits {
  hn::Vec<D> t;
  hn::Mask<D> accepted;
};

/// Primitives::accept, for regular rays: where hits at `t` are held inside the shapes' boxes.
template <class D>
HWY_INLINE AcceptedHits<D> hold(D d, const Lanes3<D>& origin, const Lanes3<D>& reciprocal,
                                const LaneBoxes<D>& boxes, hn::Vec<D> t) {
  const auto zero = hn::Zero(d);
  const auto lower_x = hn::Mul(hn::Sub(boxes.lower.x, origin.x), reciprocal.x),
             lower_y = hn::Mul(hn::Sub(boxes.lower.y, origin.y), reciprocal.y),
             lower_z = hn::Mul(hn::Sub(boxes.lower.z, origin.z), reciprocal.z),
             upper_x = hn::Mul(hn::Sub(boxes.upper.x, origin.x), reciprocal.x),
             upper_y = hn::Mul(hn::Sub(boxes.upper.y, origin.y), reciprocal.y),
             upper_z = hn::Mul(hn::Sub(boxes.upper.z, origin.z), reciprocal.z);
  // `slab` picks near and far planes by signs; of finite products they are the smaller and the larger one.
  const auto enter = hn::Max(hn::Max(hn::Min(lower_x, upper_x), hn::Min(lower_y, upper_y)),
                             hn::Max(hn::Min(lower_z, upper_z), zero));
  const auto leave = hn::Mul(
      hn::Min(hn::Max(lower_x, upper_x), hn::Min(hn::Max(lower_y, upper_y), hn::Max(lower_z, upper_z))),
      hn::Set(d, slab_widening<float>));
  const auto held = hn::Min(hn::Max(t, enter), leave);
  return {held, hn::And(hn::And(hn::Gt(t, zero), hn::Le(enter, leave)), hn::Gt(held, zero))};
}

/// TriangleShape::has_all_corners_ahead_of.
template <class D>
HWY_INLINE hn::Mask<D> has_all_corners_ahead(D d, const Lanes3<D>& origin, const Lanes3<D>& direction,
                                             const Corners<D>& triangle, const Lanes3<D>& normal) {
  const LongestAxis<D> axis(direction);
  const auto from = axis.of(origin), a = axis.of(triangle.a), b = axis.of(triangle.b),
             c = axis.of(triangle.c);
  const auto least = hn::Min(hn::Min(a, b), c), most = hn::Max(hn::Max(a, b), c);
  const auto is_ahead = hn::Or(hn::And(hn::Gt(axis.of(direction), hn::Zero(d)), hn::Gt(least, from)),
                               hn::And(hn::Lt(axis.of(direction), hn::Zero(d)), hn::Lt(most, from)));
  const auto size = hn::Max(hn::Max(hn::Abs(normal.x), hn::Abs(normal.y)), hn::Abs(normal.z));
  return hn::And(is_ahead, hn::Gt(size, hn::Zero(d)));
}

/// Primitives::accept_triangle, for regular rays and hits whose distances are known.
template <class Method, class D>
HWY_INLINE AcceptedHits<D> accept(Method, D d, const Lanes3<D>& origin, const Lanes3<D>& direction,
                                  const Lanes3<D>& reciprocal, const LaneBoxes<D>& boxes,
                                  const Corners<D>& triangle, const Lanes3<D>& normal, hn::Vec<D> t) {
  const auto zero = hn::Zero(d);
  const auto side = dot<D>(normal, minus<D>(origin, triangle.a)), towards = dot<D>(normal, direction);
  auto is_ahead = hn::Or(hn::And(hn::Gt(side, zero), hn::Lt(towards, zero)),
                         hn::And(hn::Lt(side, zero), hn::Gt(towards, zero)));
  if constexpr (Method::is_watertight)
    is_ahead = hn::Or(is_ahead, has_all_corners_ahead(d, origin, direction, triangle, normal));
  const AcceptedHits<D> held = hold(d, origin, reciprocal, boxes, t);
  return {held.t, hn::And(is_ahead, held.accepted)};
}

/// Corners of a block's triangles, with these axes for x, y and z.
template <class Block>
HWY_INLINE Corners<Floats> corners_of(const Block& block, const uint32_t (&axes)[3]) {
  const auto corner = [&](size_t row) HWY_ATTR {
    const Floats d;
    return Lanes3<Floats>{hn::Load(d, block.corners[row + axes[0]]),
                          hn::Load(d, block.corners[row + axes[1]]),
                          hn::Load(d, block.corners[row + axes[2]])};
  };
  return {corner(0), corner(3), corner(6)};
}
template <class Block>
HWY_INLINE Corners<Floats> corners_of(const Block& block) {
  static constexpr uint32_t axes[3] = {0, 1, 2};
  return corners_of(block, axes);
}

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#endif
