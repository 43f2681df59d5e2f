// Read once for each instruction set by Highway's foreach_target.h, then once more for what stands under
// HWY_ONCE.
#include "tracer/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/wide/kernels_morozov.cpp"
#include <hwy/foreach_target.h>

#include "tracer/wide/kernels-inl.h"

#if HWY_ONCE

#include "tracer/wide/kernels_for.h"

namespace raysweep {

template BatchKernels<Morozov, 4> kernels_for(std::string_view);
template BatchKernels<Morozov, 8> kernels_for(std::string_view);

}  // namespace raysweep

#endif
