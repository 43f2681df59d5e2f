// What `kernels_for` hands out, for one instruction set.
#if defined(RAYSWEEP_WIDE_KERNELS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYSWEEP_WIDE_KERNELS_INL_H_
#undef RAYSWEEP_WIDE_KERNELS_INL_H_
#else
#define RAYSWEEP_WIDE_KERNELS_INL_H_
#endif

#include "tracer/wide/packets-inl.h"
#include "tracer/wide/stream-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raysweep {
namespace HWY_NAMESPACE {

/// The rays of the groups that `scratch` lists.
template <class Method, bool any>
HWY_INLINE void run_alone(const WideGeometry<Method, lane_count>& geometry, const RayBatch& rays,
                          HitBatch& hits, KernelScratch& scratch) {
  scratch.flat_groups.clear();
  Stream<Method, any>(geometry, rays, hits, scratch, false).run();
  if (!scratch.flat_groups.empty()) Stream<Method, any>(geometry, rays, hits, scratch, true).run();
}

template <class Method, bool any>
HWY_ATTR void run_single(const WideGeometry<Method, lane_count>& geometry, const RayBatch& rays,
                         HitBatch& hits, KernelScratch& scratch) {
  scratch.left_over.clear();
  scratch.groups.clear();
  for (size_t i = 0; i < rays.size; i += packet_size) scratch.groups.push_back(static_cast<uint32_t>(i));
  run_alone<Method, any>(geometry, rays, hits, scratch);
}

template <class Method, bool any>
HWY_ATTR void run_packets(const WideGeometry<Method, lane_count>& geometry, const RayBatch& rays,
                          HitBatch& hits, KernelScratch& scratch) {
  scratch.left_over.clear();
  scratch.groups.clear();
  Packets<Method, any>(geometry, rays, hits, scratch).run();
  run_alone<Method, any>(geometry, rays, hits, scratch);
}

template <class Method>
BatchKernels<Method, lane_count> kernels() {
  return {{&run_single<Method, false>, &run_single<Method, true>},
          {&run_packets<Method, false>, &run_packets<Method, true>}};
}

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#endif
