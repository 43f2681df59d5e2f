// Read once for each instruction set by Highway's foreach_target.h, then once more for what stands under
// HWY_ONCE.
#include "experiments/kernels/highway_loops.h"

#include "tracer/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "experiments/kernels/highway_loops.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "experiments/kernels/keep.h"
#include "experiments/machine/cycle_timer.h"

HWY_BEFORE_NAMESPACE();
namespace raysweep {
namespace HWY_NAMESPACE {  // NOLINT(readability-identifier-naming): Highway's

namespace hn = hwy::HWY_NAMESPACE;

using FourLanes = hn::FixedTag<float, 4>;

void evaluate_one(const float* o, float* result) {
  const FourLanes tag;
  const auto sum = hn::Add(hn::LoadU(tag, o), hn::LoadU(tag, o + 4));
  const auto product = hn::Mul(hn::LoadU(tag, o + 12), hn::LoadU(tag, o + 16));
  hn::StoreU(hn::Sub(hn::Mul(sum, hn::LoadU(tag, o + 8)), product), tag, result);
}

void evaluate(const float* operands, uint64_t sets, uint64_t count, float* result) {
  for (uint64_t i = 0; i < count; ++i) {
    evaluate_one(operands + (i & (sets - 1)) * 20, result);  // a division would take longer than all else
    keep(*result);
  }
}

void evaluate_timed(const float* operands, uint64_t sets, uint64_t count, float* result, CycleTimer* timer) {
  for (uint64_t i = 0; i < count; ++i) {
    timer->begin();
    evaluate_one(operands + (i & (sets - 1)) * 20, result);
    keep(*result);
    timer->end();
  }
}

void dot_products(const float* a, const float* b, uint64_t count, float* products) {
  const FourLanes tag;
  for (uint64_t i = 0; i < count; ++i) {
    const auto product = hn::Mul(hn::LoadU(tag, a + 4 * i), hn::LoadU(tag, b + 4 * i));
    const auto pairs = hn::Add(product, hn::Shuffle2301(product));
    products[i] = hn::GetLane(hn::Add(pairs, hn::Shuffle1032(pairs)));
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace raysweep {

HWY_EXPORT(evaluate);
HWY_EXPORT(evaluate_timed);
HWY_EXPORT(dot_products);

void highway_evaluate(const float* operands, uint64_t sets, uint64_t count, float* result) {
  HWY_DYNAMIC_DISPATCH(evaluate)(operands, sets, count, result);
}

void highway_evaluate_timed(const float* operands, uint64_t sets, uint64_t count, float* result,
                            CycleTimer& timer) {
  HWY_DYNAMIC_DISPATCH(evaluate_timed)(operands, sets, count, result, &timer);
}

void highway_dot_products(const float* a, const float* b, uint64_t count, float* products) {
  HWY_DYNAMIC_DISPATCH(dot_products)(a, b, count, products);
}

}  // namespace raysweep

#endif
