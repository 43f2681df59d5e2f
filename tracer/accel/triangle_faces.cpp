// Read once for each instruction set by Highway's foreach_target.h, then once more for what stands under
// HWY_ONCE.
#include "tracer/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/accel/triangle_faces.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "tracer/accel/triangle_faces.h"

HWY_BEFORE_NAMESPACE();
namespace raysweep {
namespace HWY_NAMESPACE {

/// Together with all that it calls: loops that compilers turn into vectors.
[[gnu::flatten]] HWY_ATTR std::array<TriangleFace<float>, faces_at_once> faces(
    const std::array<Triangle<float>, faces_at_once>& triangles) {
  return faces_of(triangles);
}

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace raysweep {

HWY_EXPORT(faces);

template <>
std::array<TriangleFace<float>, faces_at_once> wide_faces_of(
    const std::array<Triangle<float>, faces_at_once>& triangles) {
  return HWY_DYNAMIC_DISPATCH(faces)(triangles);
}

}  // namespace raysweep

#endif
