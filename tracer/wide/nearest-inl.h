// Which of the hits that a method has found in a block is a ray's nearest.
#if defined(RAYSWEEP_WIDE_NEAREST_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYSWEEP_WIDE_NEAREST_INL_H_
#undef RAYSWEEP_WIDE_NEAREST_INL_H_
#else
#define RAYSWEEP_WIDE_NEAREST_INL_H_
#endif

#include "tracer/wide/accept-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raysweep {
namespace HWY_NAMESPACE {

/// One ray, with what `SlabRay` keeps of it; fourth lanes repeat the first ones.
struct OneRay {
  AxisLanes origin, direction, reciprocal;
  uint32_t longest_axis;  // of the direction, for methods that shear

  [[nodiscard]] HWY_INLINE Ray<float> ray() const { return {vec_of(origin), vec_of(direction)}; }
  [[nodiscard]] HWY_INLINE SlabRay<float> slab_ray() const {
    return SlabRay<float>(ray(), vec_of(reciprocal));
  }

 private:
  HWY_INLINE static Vec3f vec_of(AxisLanes v) {
    return {hn::GetLane(v), hn::ExtractLane(v, 1), hn::ExtractLane(v, 2)};
  }
};

/// `nearest`, or what comes before it among the block's triangles in `lanes`, asked one by one.
template <class Method, class Block>
HWY_INLINE Hit<float> nearest_one_by_one(const Primitives<float, Method>& primitives, const Block& block,
                                         const Ray<float>& ray, const SlabRay<float>& slab_ray,
                                         const float* distances, uint32_t lanes, Hit<float> nearest) {
  for (uint32_t left = lanes; left != 0; left &= left - 1) {
    const size_t lane = hwy::Num0BitsBelowLS1Bit_Nonzero32(left);
    const auto t =
        primitives.accept_triangle(block.id[lane], distances[lane], ray, slab_ray, Hit<float>::start());
    if (t && Hit<float>{*t, block.id[lane]}.before(nearest)) nearest = {*t, block.id[lane]};
  }
  return nearest;
}

/// One lane of three rows: x, y, z, x.
template <size_t width>
HWY_INLINE AxisLanes point_of(const float (*rows)[width], size_t lane) {
  const Axes d;
  return hn::InsertLane(hn::InsertLane(hn::Set(d, rows[0][lane]), 1, rows[1][lane]), 2, rows[2][lane]);
}

/// Primitives::accept_triangle as `accept` does it, but with x, y and z side by side: the distance at which
/// one regular ray's hit of one triangle at `t` counts, or NaN.
template <class Method, class Block>
HWY_INLINE float accepted_at(const OneRay& ray, const Block& block, size_t lane, float t) {
  const Axes d;
  const AxisLanes a = point_of(block.corners, lane), b = point_of(block.corners + 3, lane),
                  c = point_of(block.corners + 6, lane), normal = point_of(block.normal, lane);
  const AxisLanes least = hn::Min(hn::Min(a, b), c), most = hn::Max(hn::Max(a, b), c);
  const AxisLanes by =
      hn::Mul(hn::MaxOfLanes(d, hn::Max(hn::Abs(least), hn::Abs(most))), hn::Set(d, box_padding<float>));
  const AxisLanes lower = hn::Mul(hn::Sub(hn::Sub(least, by), ray.origin), ray.reciprocal),
                  upper = hn::Mul(hn::Sub(hn::Add(most, by), ray.origin), ray.reciprocal);
  const float enter = std::max(hn::GetLane(hn::MaxOfLanes(d, hn::Min(lower, upper))), 0.0f);
  const float leave = hn::GetLane(hn::MinOfLanes(d, hn::Max(lower, upper))) * slab_widening<float>;
  const float held = std::min(std::max(t, enter), leave);
  const auto sum = [](AxisLanes products) HWY_ATTR {  // as `dot` adds
    return hn::GetLane(products) + hn::ExtractLane(products, 1) + hn::ExtractLane(products, 2);
  };
  const float side = sum(hn::Mul(normal, hn::Sub(ray.origin, a))),
              towards = sum(hn::Mul(normal, ray.direction));
  bool is_ahead = ((side > 0) & (towards < 0)) | ((side < 0) & (towards > 0));
  if constexpr (Method::is_watertight) {
    const AxisLanes zero = hn::Zero(d);
    const uint32_t axes = bits_of(hn::Or(hn::And(hn::Gt(ray.direction, zero), hn::Gt(least, ray.origin)),
                                         hn::And(hn::Lt(ray.direction, zero), hn::Lt(most, ray.origin))));
    const bool is_degenerate = hn::AllFalse(d, hn::Ne(normal, zero));
    is_ahead |= ((axes >> ray.longest_axis) & 1) != 0 && !is_degenerate;
  }
  const bool is_held = (t > 0) & (enter <= leave) & (held > 0);
  return (is_ahead & is_held) ? held : std::numeric_limits<float>::quiet_NaN();
}

/// A bit for each lane at whose distance there is a hit. Infinity: none; NaN: lanes cannot tell.
HWY_INLINE uint32_t hits_at(const float* distances) {
  const Floats d;
  return bits_of(hn::Lt(hn::Load(d, distances), hn::Set(d, std::numeric_limits<float>::infinity())));
}
HWY_INLINE uint32_t undecided_at(const float* distances) {
  return bits_of(hn::IsNaN(hn::Load(Floats(), distances)));
}

/// The first of a regular ray's hits at `distances` that counts. Hardly ever is there more than one, so each
/// is looked at by itself.
template <class Method, class Block>
HWY_INLINE Hit<float> nearest_triangle(const Primitives<float, Method>& primitives, const Block& block,
                                       const OneRay& ray, const float* distances) {
  Hit<float> nearest = Hit<float>::none();
  for (uint32_t left = hits_at(distances); left != 0; left &= left - 1) {
    const size_t lane = hwy::Num0BitsBelowLS1Bit_Nonzero32(left);
    const Hit<float> found{accepted_at<Method>(ray, block, lane, distances[lane]), block.id[lane]};
    if (found.before(nearest)) nearest = found;
  }
  if constexpr (Method::is_watertight) {
    const uint32_t undecided = undecided_at(distances);
    if (undecided != 0)
      return nearest_one_by_one(primitives, block, ray.ray(), ray.slab_ray(), distances, undecided, nearest);
  }
  return nearest;
}

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#endif
