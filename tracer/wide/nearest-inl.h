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

/// One ray, with what `SlabRay` keeps of it.
struct RayNumbers {
  Vec3f origin, direction, reciprocal;

  [[nodiscard]] HWY_INLINE Ray<float> ray() const { return {origin, direction}; }
  [[nodiscard]] HWY_INLINE SlabRay<float> slab_ray() const { return SlabRay<float>(ray(), reciprocal); }
};

/// `nearest`, or what comes before it among the block's triangles in `lanes`, asked one by one.
template <class Method, class Block>
HWY_INLINE Hit<float> nearest_one_by_one(const Primitives<float, Method>& primitives, const Block& block,
                                         const Ray<float>& ray, const SlabRay<float>& slab_ray,
                                         const float* distances, LaneMask lanes, Hit<float> nearest) {
  for (uint32_t left = bits_of(lanes); left != 0; left &= left - 1) {
    const size_t lane = hwy::Num0BitsBelowLS1Bit_Nonzero32(left);
    const auto t =
        primitives.accept_triangle(block.id[lane], distances[lane], ray, slab_ray, Hit<float>::start());
    if (t && Hit<float>{*t, block.id[lane]}.before(nearest)) nearest = {*t, block.id[lane]};
  }
  return nearest;
}

/// The first of a regular ray's hits at `distances` that counts. Infinity: not hit; NaN: lanes cannot tell.
/// Hardly ever is there more than one, so each is looked at by itself.
template <class Method, class Block>
HWY_INLINE Hit<float> nearest_triangle(const Primitives<float, Method>& primitives, const Block& block,
                                       const RayNumbers& ray, const float* distances) {
  using One = hn::FixedTag<float, 1>;
  const One d;
  const auto vector = [](const Vec3f& v) HWY_ATTR { return broadcast(One(), v.x, v.y, v.z); };
  const FloatLanes t = hn::Load(Floats(), distances);
  Hit<float> nearest = Hit<float>::none();
  for (uint32_t left = bits_of(hn::Lt(t, hn::Set(Floats(), std::numeric_limits<float>::infinity())));
       left != 0; left &= left - 1) {
    const size_t lane = hwy::Num0BitsBelowLS1Bit_Nonzero32(left);
    const auto of_lane = [lane](const float(*rows)[lane_count]) HWY_ATTR {
      return broadcast(One(), rows[0][lane], rows[1][lane], rows[2][lane]);
    };
    const Corners<One> corners{of_lane(block.corners), of_lane(block.corners + 3),
                               of_lane(block.corners + 6)};
    const AcceptedHits<One> hit =
        accept(Method{}, d, vector(ray.origin), vector(ray.direction), vector(ray.reciprocal),
               boxes_of(d, corners), corners, of_lane(block.normal), hn::Set(d, distances[lane]));
    const Hit<float> found{hn::GetLane(hit.t), block.id[lane]};
    if (hn::AllTrue(d, hit.accepted) && found.before(nearest)) nearest = found;
  }
  if constexpr (Method::is_watertight) {
    const LaneMask is_undecided = hn::IsNaN(t);
    if (!hn::AllFalse(Floats(), is_undecided))
      return nearest_one_by_one(primitives, block, ray.ray(), ray.slab_ray(), distances, is_undecided,
                                nearest);
  }
  return nearest;
}

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#endif
