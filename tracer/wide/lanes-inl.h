// Vectors of lanes and the methods over them. Read once for each instruction set, hence the guard of
// Highway's kind.
#if defined(RAYSWEEP_WIDE_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYSWEEP_WIDE_LANES_INL_H_
#undef RAYSWEEP_WIDE_LANES_INL_H_
#else
#define RAYSWEEP_WIDE_LANES_INL_H_
#endif

#include <hwy/highway.h>

#include "tracer/intersect/moller_trumbore.h"
#include "tracer/intersect/morozov.h"
#include "tracer/intersect/woop_watertight.h"
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

/// Corners of triangles.
template <class D>
struct Corners {
  Lanes3<D> a, b, c;
};

/// TriangleHit of each lane, before any test.
template <class D>
struct LaneHits {
  hn::Vec<D> t, beta, gamma;
};

/// MollerTrumbore::prepare and, without its early ends, MollerTrumbore::intersect.
template <class D>
HWY_INLINE LaneHits<D> solve(MollerTrumbore, D d, const Lanes3<D>& origin, const Lanes3<D>& direction,
                             const Corners<D>& triangle) {
  const Lanes3<D> ab = minus<D>(triangle.b, triangle.a), ac = minus<D>(triangle.c, triangle.a);
  const Lanes3<D> p = cross<D>(direction, ac);
  const auto inverse = hn::Div(hn::Set(d, 1.0f), dot<D>(ab, p));
  const Lanes3<D> ao = minus<D>(origin, triangle.a);
  const Lanes3<D> q = cross<D>(ao, ab);
  return {hn::Mul(dot<D>(ac, q), inverse), hn::Mul(dot<D>(ao, p), inverse),
          hn::Mul(dot<D>(direction, q), inverse)};
}

/// Morozov::prepare and, without its early ends, Morozov::intersect.
template <class D>
HWY_INLINE LaneHits<D> solve(Morozov, D d, const Lanes3<D>& origin, const Lanes3<D>& direction,
                             const Corners<D>& triangle) {
  const Lanes3<D> e1 = minus<D>(triangle.a, triangle.b), e2 = minus<D>(triangle.c, triangle.a);
  const Lanes3<D> n = cross<D>(e2, e1);
  const auto inverse = hn::Div(hn::Set(d, 1.0f), dot<D>(direction, n));
  const Lanes3<D> to_plane = minus<D>(triangle.a, origin);
  const Lanes3<D> s = cross<D>(to_plane, direction);
  return {hn::Mul(dot<D>(to_plane, n), inverse), hn::Mul(dot<D>(s, e2), inverse),
          hn::Mul(dot<D>(s, e1), inverse)};
}

/// Lanes with 0 < t < ∞, β ≥ 0, γ ≥ 0, β + γ ≤ 1; NaN anywhere is a miss.
template <class D>
HWY_INLINE hn::Mask<D> is_hit(D d, const LaneHits<D>& hits) {
  const auto zero = hn::Zero(d);
  const auto inside = hn::And(hn::And(hn::Ge(hits.beta, zero), hn::Ge(hits.gamma, zero)),
                              hn::Le(hn::Add(hits.beta, hits.gamma), hn::Set(d, 1.0f)));
  const auto ahead =
      hn::And(hn::Gt(hits.t, zero), hn::Lt(hits.t, hn::Set(d, std::numeric_limits<float>::infinity())));
  return hn::And(inside, ahead);
}

/// Lanes that WoopWatertight hits. Where floats leave an edge function uncertain, the lane counts and its
/// distance is NaN: Primitives::accept_triangle asks the method itself.
template <class D>
struct WatertightHits {
  hn::Vec<D> t;
  hn::Mask<D> mask;
};

template <class D>
HWY_INLINE hn::Mask<D> is_hit(D, const WatertightHits<D>& hits) {
  return hits.mask;
}

/// Swaps the axis along which the direction is longest for z. One ray's is the same in all lanes, but a
/// choice without branches costs less than a guess that fails.
template <class D>
class LongestAxis {
 public:
  HWY_INLINE explicit LongestAxis(const Lanes3<D>& direction) {
    const auto x = hn::Abs(direction.x), y = hn::Abs(direction.y), z = hn::Abs(direction.z);
    is_x_ = hn::And(hn::Gt(x, y), hn::Gt(x, z));
    is_y_ = hn::AndNot(is_x_, hn::Gt(y, z));
  }
  HWY_INLINE Lanes3<D> as_z(const Lanes3<D>& p) const {
    return {hn::IfThenElse(is_x_, p.z, p.x), hn::IfThenElse(is_y_, p.z, p.y), z_of(p)};
  }
  HWY_INLINE hn::Vec<D> z_of(const Lanes3<D>& p) const {
    return hn::IfThenElse(is_x_, p.x, hn::IfThenElse(is_y_, p.y, p.z));
  }

 private:
  hn::Mask<D> is_x_, is_y_;
};

/// The formula of WoopWatertight::intersect up to where it turns to double.
template <class D>
HWY_INLINE WatertightHits<D> solve(WoopWatertight, D d, const Lanes3<D>& origin, const Lanes3<D>& direction,
                                   const Corners<D>& triangle) {
  const LongestAxis<D> axis(direction);
  const Lanes3<D> towards = axis.as_z(direction);
  const auto along = hn::Div(hn::Set(d, 1.0f), towards.z);
  const auto by_x = hn::Mul(towards.x, along), by_y = hn::Mul(towards.y, along);
  const auto sheared = [&](const Lanes3<D>& corner) HWY_ATTR {
    const Lanes3<D> p = axis.as_z(minus<D>(corner, origin));
    return Lanes3<D>{hn::Sub(p.x, hn::Mul(by_x, p.z)), hn::Sub(p.y, hn::Mul(by_y, p.z)), p.z};
  };
  const Lanes3<D> a = sheared(triangle.a), b = sheared(triangle.b), c = sheared(triangle.c);
  const auto edge = [](const Lanes3<D>& p, const Lanes3<D>& q)
                        HWY_ATTR { return hn::Sub(hn::Mul(p.x, q.y), hn::Mul(p.y, q.x)); };
  const auto u = edge(c, b), v = edge(a, c), w = edge(b, a);
  // Where one of them is NaN, so is the distance.
  const auto is_inside =
      hn::Or(hn::Ge(hn::Min(hn::Min(u, v), w), hn::Zero(d)), hn::Le(hn::Max(hn::Max(u, v), w), hn::Zero(d)));
  const auto least = hn::Min(hn::Min(hn::Abs(u), hn::Abs(v)), hn::Abs(w));
  const auto is_uncertain = hn::Lt(least, hn::Set(d, WoopWatertight::least_certain<float>));
  const auto inverse = hn::Div(hn::Set(d, 1.0f), hn::Add(hn::Add(u, v), w));
  const auto sum = hn::Add(hn::Add(hn::Mul(hn::Mul(u, inverse), a.z), hn::Mul(hn::Mul(v, inverse), b.z)),
                           hn::Mul(hn::Mul(w, inverse), c.z));
  const auto t = hn::Mul(sum, along);
  const auto is_ahead =
      hn::And(hn::Gt(t, hn::Zero(d)), hn::Lt(t, hn::Set(d, std::numeric_limits<float>::infinity())));
  return {hn::IfThenElse(is_uncertain, hn::NaN(d), t), hn::And(is_inside, hn::Or(is_uncertain, is_ahead))};
}

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
  const auto from = axis.z_of(origin), a = axis.z_of(triangle.a), b = axis.z_of(triangle.b),
             c = axis.z_of(triangle.c);
  const auto least = hn::Min(hn::Min(a, b), c), most = hn::Max(hn::Max(a, b), c);
  const auto is_ahead = hn::Or(hn::And(hn::Gt(axis.z_of(direction), hn::Zero(d)), hn::Gt(least, from)),
                               hn::And(hn::Lt(axis.z_of(direction), hn::Zero(d)), hn::Lt(most, from)));
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

/// SphereHit of each lane, and which meet the sphere at all.
template <class D>
struct LaneSphereHits {
  hn::Vec<D> enter, leave;
  hn::Mask<D> is_met;
};

/// The formula of intersect_sphere.
template <class D>
HWY_INLINE LaneSphereHits<D> solve_sphere(D d, const Lanes3<D>& origin, const Lanes3<D>& direction,
                                          const Lanes3<D>& centre, hn::Vec<D> radius) {
  const auto zero = hn::Zero(d);
  const Lanes3<D> f = minus<D>(origin, centre);
  const auto a = dot<D>(direction, direction), b = hn::Neg(dot<D>(f, direction)),
             square = hn::Mul(radius, radius), c = hn::Sub(dot<D>(f, f), square), along = hn::Div(b, a);
  const Lanes3<D> from_centre{hn::Add(f.x, hn::Mul(along, direction.x)),
                              hn::Add(f.y, hn::Mul(along, direction.y)),
                              hn::Add(f.z, hn::Mul(along, direction.z))};
  auto discriminant = hn::Sub(square, dot<D>(from_centre, from_centre));
  discriminant = hn::IfThenElse(hn::Lt(c, zero), hn::Max(discriminant, zero), discriminant);
  const auto q = hn::Add(b, hn::CopySign(hn::Sqrt(hn::Mul(a, discriminant)), b));
  const auto t0 = hn::IfThenElse(hn::Eq(q, zero), zero, hn::Div(c, q)), t1 = hn::Div(q, a);
  return {hn::Min(t0, t1), hn::Max(t0, t1), hn::Ge(discriminant, zero)};
}

/// One bit a lane.
HWY_INLINE uint32_t bits_of(LaneMask mask) {
  uint8_t bits[8];  // Highway writes up to 8 bytes
  hn::StoreMaskBits(Floats(), mask, bits);
  return bits[0];
}

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

/// Moves the lanes of a mask to the front, in their order.
class Compaction {
 public:
  HWY_INLINE explicit Compaction(LaneMask mask)
#if HWY_TARGET == HWY_AVX3
      : mask_(mask) {
  }
  [[nodiscard]] HWY_INLINE uint32_t count() const {
    return static_cast<uint32_t>(hn::CountTrue(Floats(), mask_));
  }
  HWY_INLINE FloatLanes operator()(FloatLanes lanes) const { return hn::Compress(lanes, mask_); }
  HWY_INLINE WordLanes operator()(WordLanes lanes) const {
    return hn::Compress(lanes, hn::RebindMask(Words(), mask_));
  }

 private:
  LaneMask mask_;
#else
      // Highway 1.0's own way, where there is no instruction, copies its table each time.
      : bits_(bits_of(mask)), numbers_(unpack(compactions[bits_])) {
  }
  [[nodiscard]] HWY_INLINE uint32_t count() const { return static_cast<uint32_t>(hwy::PopCount(bits_)); }
  HWY_INLINE FloatLanes operator()(FloatLanes lanes) const { return permute(lanes, numbers_); }
  HWY_INLINE WordLanes operator()(WordLanes lanes) const { return permute(lanes, numbers_); }

 private:
  uint32_t bits_;
  WordLanes numbers_;
#endif
};

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#endif
