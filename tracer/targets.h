// Which instruction sets Highway compiles the wide core for; to be read before anything of Highway.
#pragma once

// What the sets left out would add (SSSE3, AVX-512 of Ice Lake) is not used here; vectors of SVE have no size
// to the compiler, so that nothing can hold them.
#define RAYSWEEP_UNUSED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
// Under sanitizers a set takes the compiler minutes: one is enough beside what every processor has.
#ifdef RAYSWEEP_FEW_TARGETS
#define HWY_DISABLED_TARGETS (RAYSWEEP_UNUSED_TARGETS | HWY_SSE4 | HWY_AVX3)
#else
#define HWY_DISABLED_TARGETS RAYSWEEP_UNUSED_TARGETS
#endif
// The bug for which Highway gives up its portable 128-bit vectors is in 16-bit multiplication (GCC 106322),
// which is not used here either.
#define HWY_BROKEN_EMU128 0

#include <hwy/targets.h>
