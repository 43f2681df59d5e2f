// Loops whose bodies are done in two halves.
#if defined(RAYSWEEP_WIDE_TWO_STEPS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYSWEEP_WIDE_TWO_STEPS_INL_H_
#undef RAYSWEEP_WIDE_TWO_STEPS_INL_H_
#else
#define RAYSWEEP_WIDE_TWO_STEPS_INL_H_
#endif

#include "tracer/wide/lanes-inl.h"

// Behind the parameters of a half, a lambda: it is called in several places, and a call would pass vectors
// through memory.
#ifndef RAYSWEEP_STEP
#define RAYSWEEP_STEP HWY_ATTR __attribute__((always_inline))
#endif

HWY_BEFORE_NAMESPACE();
namespace raysweep {
namespace HWY_NAMESPACE {

/// `second(first(i), i)` for each i below `count`, in order, where `first` is `ahead` steps ahead of
/// `second`. A body whose results are known only after some 70 cycles holds its place in the processor as
/// long, and no more than four or five of them have room; of halves that wait for less, more have.
template <uint32_t ahead, class First, class Second>
HWY_INLINE void in_two_steps(uint32_t count, const First& first, const Second& second) {
  if (count <= ahead) {
    for (uint32_t i = 0; i < count; ++i) second(first(i), i);
    return;
  }
  static_assert(ahead == 1 || ahead == 2);
  // Not in an array, which compilers keep in memory.
  auto oldest = first(0);
  if constexpr (ahead == 1) {
    for (uint32_t i = 1; i < count; ++i) {
      const auto next = first(i);
      second(oldest, i - 1);
      oldest = next;
    }
    second(oldest, count - 1);
  } else {
    auto newest = first(1);
    for (uint32_t i = 2; i < count; ++i) {
      const auto next = first(i);
      second(oldest, i - 2);
      oldest = newest;
      newest = next;
    }
    second(oldest, count - 2);
    second(newest, count - 1);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#endif
