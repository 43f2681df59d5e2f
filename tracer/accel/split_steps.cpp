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

[[gnu::flatten]] HWY_ATTR void fill(Bins<float>& bins, std::span<const Reference<float>> references,
                                    const BinMapping<float>& mapping) {
  bins.add(references, mapping);
}

[[gnu::flatten]] HWY_ATTR SplitPlane<float> cheapest(const Bins<float>& bins, int count, int block_shift) {
  return PlaneSweep<float>(bins, count, block_shift).cheapest();
}

[[gnu::flatten]] HWY_ATTR SplitSteps<float>::Moved move(std::span<const Reference<float>> references,
                                                        const BinMapping<float>& mapping,
                                                        const SplitPlane<float>& plane,
                                                        Reference<float>* left, Reference<float>* right) {
  return move_to_sides<float>(references, mapping, plane, left, right);
}

SplitSteps<float> split_steps() { return {&fill, &cheapest, &move}; }

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace raysweep {

HWY_EXPORT(split_steps);

template <>
SplitSteps<float> SplitSteps<float>::here() {
  return HWY_DYNAMIC_DISPATCH(split_steps)();
}

/// Plain: where vectors of 32 bytes are no machine's own, nothing aligns them, which AVX would ask for.
template <>
SplitSteps<double> SplitSteps<double>::here() {
  using References = std::span<const Reference<double>>;
  return {[](Bins<double>& bins, References references, const BinMapping<double>& mapping) {
            bins.add(references, mapping);
          },
          [](const Bins<double>& bins, int count, int block_shift) {
            return PlaneSweep<double>(bins, count, block_shift).cheapest();
          },
          &move_to_sides<double>};
}

}  // namespace raysweep

#endif
