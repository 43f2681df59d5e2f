// The choice among the kernels of a method; for its source alone, which has compiled them for every
// instruction set.
#pragma once

#include <type_traits>

#include "tracer/wide/isa.h"
#include "tracer/wide/kernels.h"

namespace raysweep {

template <class Method, int width>
BatchKernels<Method, width> kernels_for(std::string_view isa) {
  BatchKernels<Method, width> found;
  if (!runs_here(isa)) return found;
  const auto take = [&](std::string_view name, const auto& kernels) {
    if constexpr (std::is_same_v<BatchKernels<Method, width>, std::decay_t<decltype(kernels)>>) {
      if (name == isa) found = kernels;
    }
  };
#if (HWY_TARGETS & HWY_AVX3) != 0
  take("avx512", N_AVX3::kernels<Method>());
#endif
#if (HWY_TARGETS & HWY_AVX2) != 0
  take("avx2", N_AVX2::kernels<Method>());
#endif
#if (HWY_TARGETS & HWY_SSE4) != 0
  take("sse4", N_SSE4::kernels<Method>());
#endif
#if (HWY_TARGETS & HWY_NEON) != 0
  take("neon", N_NEON::kernels<Method>());
#endif
#if (HWY_TARGETS & HWY_EMU128) != 0
  take("baseline", N_EMU128::kernels<Method>());
#endif
  return found;
}

}  // namespace raysweep
