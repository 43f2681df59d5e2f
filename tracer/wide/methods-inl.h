// The intersection methods, and the sphere, in lanes: their own operations in their own order, so that
// results are equal bit for bit.
#if defined(RAYSWEEP_WIDE_METHODS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYSWEEP_WIDE_METHODS_INL_H_
#undef RAYSWEEP_WIDE_METHODS_INL_H_
#else
#define RAYSWEEP_WIDE_METHODS_INL_H_
#endif

#include "tracer/intersect/moller_trumbore.h"
#include "tracer/intersect/morozov.h"
#include "tracer/intersect/woop_watertight.h"
#include "tracer/wide/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raysweep {
namespace HWY_NAMESPACE {

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

/// The same times a divisor.
template <class D>
struct Quotients {
  hn::Vec<D> t, beta, gamma, divisor;
};
template <class D>
HWY_INLINE LaneHits<D> divide(D d, const Quotients<D>& q) {
  const auto inverse = hn::Div(hn::Set(d, 1.0f), q.divisor);
  return {hn::Mul(q.t, inverse), hn::Mul(q.beta, inverse), hn::Mul(q.gamma, inverse)};
}

/// What is known of triangles before a ray's direction: a few vectors each, which differ from method to
/// method.
template <class D, size_t count>
struct TriangleVectors {
  Lanes3<D> v[count];
};

/// MollerTrumbore::prepare: A, AB, AC.
template <class D>
HWY_INLINE TriangleVectors<D, 3> prepare(MollerTrumbore, const Corners<D>& t) {
  return {{t.a, minus<D>(t.b, t.a), minus<D>(t.c, t.a)}};
}
/// What MollerTrumbore::intersect computes from the origin: AO, Q, AB, AC.
template <class D>
HWY_INLINE TriangleVectors<D, 4> seen_from(MollerTrumbore, const Lanes3<D>& origin,
                                           const TriangleVectors<D, 3>& prepared) {
  const auto& [a, ab, ac] = prepared.v;
  const Lanes3<D> ao = minus<D>(origin, a);
  return {{ao, cross<D>(ao, ab), ab, ac}};
}
/// The rest of it, without its early ends, up to its division.
template <class D>
HWY_INLINE Quotients<D> project(MollerTrumbore, const Lanes3<D>& direction,
                                const TriangleVectors<D, 4>& seen) {
  const auto& [ao, q, ab, ac] = seen.v;
  const Lanes3<D> p = cross<D>(direction, ac);
  return {dot<D>(ac, q), dot<D>(ao, p), dot<D>(direction, q), dot<D>(ab, p)};
}

/// Morozov::prepare: A, E1, E2, N.
template <class D>
HWY_INLINE TriangleVectors<D, 4> prepare(Morozov, const Corners<D>& t) {
  const Lanes3<D> e1 = minus<D>(t.a, t.b), e2 = minus<D>(t.c, t.a);
  return {{t.a, e1, e2, cross<D>(e2, e1)}};
}
/// OA, E1, E2, N.
template <class D>
HWY_INLINE TriangleVectors<D, 4> seen_from(Morozov, const Lanes3<D>& origin,
                                           const TriangleVectors<D, 4>& prepared) {
  const auto& [a, e1, e2, n] = prepared.v;
  return {{minus<D>(a, origin), e1, e2, n}};
}
/// Morozov::intersect without its early ends, up to its division.
template <class D>
HWY_INLINE Quotients<D> project(Morozov, const Lanes3<D>& direction, const TriangleVectors<D, 4>& seen) {
  const auto& [to_plane, e1, e2, n] = seen.v;
  const Lanes3<D> s = cross<D>(to_plane, direction);
  return {dot<D>(to_plane, n), dot<D>(s, e2), dot<D>(s, e1), dot<D>(direction, n)};
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

/// The `longest_axis` of directions.
template <class D>
class LongestAxis {
 public:
  HWY_INLINE explicit LongestAxis(const Lanes3<D>& direction) {
    const auto x = hn::Abs(direction.x), y = hn::Abs(direction.y), z = hn::Abs(direction.z);
    is_x_ = hn::And(hn::Gt(x, y), hn::Gt(x, z));
    is_y_ = hn::AndNot(is_x_, hn::Gt(y, z));
  }
  /// Along it.
  HWY_INLINE hn::Vec<D> of(const Lanes3<D>& p) const {
    return hn::IfThenElse(is_x_, p.x, hn::IfThenElse(is_y_, p.y, p.z));
  }
  /// Which one it is.
  [[nodiscard]] HWY_INLINE hn::Vec<D> number() const {
    const D d;
    return hn::IfThenElse(is_x_, hn::Zero(d), hn::IfThenElse(is_y_, hn::Set(d, 1.0f), hn::Set(d, 2.0f)));
  }

 private:
  hn::Mask<D> is_x_, is_y_;
};

/// Whether a method shears: swaps the longest axis of a direction for z and takes, in its place, what
/// `WoopWatertight::Shear` does: by_x, by_y, along.
template <class Method>
inline constexpr bool shears = std::is_same_v<Method, WoopWatertight>;

/// The axes that a method takes for x, y and z where `longest` is the longest one. Swapped twice they are
/// back.
template <class Method>
HWY_INLINE const uint32_t (&axes_of(uint32_t longest))[3] {
  static constexpr uint32_t swapped[3][3] = {{2, 1, 0}, {0, 2, 1}, {0, 1, 2}};
  return swapped[shears<Method> ? longest : 2];
}

/// The same where each lane has a longest axis of its own.
template <class D>
class AxisSwap {
 public:
  HWY_INLINE explicit AxisSwap(hn::Vec<D> longest)
      : is_x_(hn::Eq(longest, hn::Zero(D()))), is_y_(hn::Eq(longest, hn::Set(D(), 1.0f))) {}
  HWY_INLINE Lanes3<D> operator()(const Lanes3<D>& p) const {
    return {hn::IfThenElse(is_x_, p.z, p.x), hn::IfThenElse(is_y_, p.z, p.y),
            hn::IfThenElse(is_x_, p.x, hn::IfThenElse(is_y_, p.y, p.z))};
  }
  template <size_t count>
  HWY_INLINE TriangleVectors<D, count> operator()(const TriangleVectors<D, count>& of) const {
    TriangleVectors<D, count> swapped;
    for (size_t i = 0; i < count; ++i) swapped.v[i] = (*this)(of.v[i]);
    return swapped;
  }

 private:
  hn::Mask<D> is_x_, is_y_;
};

/// A, B, C.
template <class D>
HWY_INLINE TriangleVectors<D, 3> prepare(WoopWatertight, const Corners<D>& t) {
  return {{t.a, t.b, t.c}};
}
/// OA, OB, OC.
template <class D>
HWY_INLINE TriangleVectors<D, 3> seen_from(WoopWatertight, const Lanes3<D>& origin,
                                           const TriangleVectors<D, 3>& prepared) {
  const auto& [a, b, c] = prepared.v;
  return {{minus<D>(a, origin), minus<D>(b, origin), minus<D>(c, origin)}};
}
/// The edge functions and the corners' distances along the longest axis.
template <class D>
struct Edges {
  hn::Vec<D> u, v, w, a, b, c, along;
};
/// The formula of WoopWatertight::intersect up to its division, axes being swapped already.
template <class D>
HWY_INLINE Edges<D> project(WoopWatertight, const Lanes3<D>& shear, const TriangleVectors<D, 3>& seen) {
  const auto sheared = [&](const Lanes3<D>& p) HWY_ATTR {
    return Lanes3<D>{hn::Sub(p.x, hn::Mul(shear.x, p.z)), hn::Sub(p.y, hn::Mul(shear.y, p.z)), p.z};
  };
  const Lanes3<D> a = sheared(seen.v[0]), b = sheared(seen.v[1]), c = sheared(seen.v[2]);
  const auto edge = [](const Lanes3<D>& p, const Lanes3<D>& q)
                        HWY_ATTR { return hn::Sub(hn::Mul(p.x, q.y), hn::Mul(p.y, q.x)); };
  return {edge(c, b), edge(a, c), edge(b, a), a.z, b.z, c.z, shear.z};
}
/// And on to where it turns to double.
template <class D>
HWY_INLINE WatertightHits<D> divide(D d, const Edges<D>& edges) {
  const auto& [u, v, w, a, b, c, along] = edges;
  // Where one of them is NaN, so is the distance.
  const auto is_inside =
      hn::Or(hn::Ge(hn::Min(hn::Min(u, v), w), hn::Zero(d)), hn::Le(hn::Max(hn::Max(u, v), w), hn::Zero(d)));
  const auto least = hn::Min(hn::Min(hn::Abs(u), hn::Abs(v)), hn::Abs(w));
  const auto is_uncertain = hn::Lt(least, hn::Set(d, WoopWatertight::least_certain<float>));
  const auto inverse = hn::Div(hn::Set(d, 1.0f), hn::Add(hn::Add(u, v), w));
  const auto sum = hn::Add(hn::Add(hn::Mul(hn::Mul(u, inverse), a), hn::Mul(hn::Mul(v, inverse), b)),
                           hn::Mul(hn::Mul(w, inverse), c));
  const auto t = hn::Mul(sum, along);
  const auto is_ahead =
      hn::And(hn::Gt(t, hn::Zero(d)), hn::Lt(t, hn::Set(d, std::numeric_limits<float>::infinity())));
  return {hn::IfThenElse(is_uncertain, hn::NaN(d), t), hn::And(is_inside, hn::Or(is_uncertain, is_ahead))};
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

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#endif
