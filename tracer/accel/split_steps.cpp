// Read once for each instruction set by Highway's foreach_target.h, then once more for what stands under
// HWY_ONCE.
#include "tracer/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/accel/split_steps.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "tracer/accel/split_steps.h"

HWY_BEFORE_NAMESPACE();
namespace raysweep {
namespace HWY_NAMESPACE {

// Each together with all that it calls, which is plain code.

template <class T>
[[gnu::flatten]] HWY_ATTR void fill(Bins<T>& bins, std::span<const Reference<T>> references,
                                    const BinMapping<T>& mapping) {
  bins.add(references, mapping);
}

template <class T>
[[gnu::flatten]] HWY_ATTR SplitPlane<T> cheapest(const Bins<T>& bins, int count, int block_shift) {
  return PlaneSweep<T>(bins, count, block_shift).cheapest();
}

template <class T>
[[gnu::flatten]] HWY_ATTR typename SplitSteps<T>::Moved move(std::span<const Reference<T>> references,
                                                             const BinMapping<T>& mapping,
                                                             const SplitPlane<T>& plane, Reference<T>* left,
                                                             Reference<T>* right) {
  return move_to_sides<T>(references, mapping, plane, left, right);
}

template <class T>
SplitSteps<T> split_steps() {
  return {&fill<T>, &cheapest<T>, &move<T>};
}
SplitSteps<float> float_steps() { return split_steps<float>(); }
SplitSteps<double> double_steps() { return split_steps<double>(); }

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace raysweep {

HWY_EXPORT(float_steps);
HWY_EXPORT(double_steps);

template <>
SplitSteps<float> SplitSteps<float>::here() {
  return HWY_DYNAMIC_DISPATCH(float_steps)();
}
template <>
SplitSteps<double> SplitSteps<double>::here() {
  return HWY_DYNAMIC_DISPATCH(double_steps)();
}

}  // namespace raysweep

#endif
