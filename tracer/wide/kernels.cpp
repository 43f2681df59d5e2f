// Read once for each instruction set by Highway's foreach_target.h, then once more for what stands under
// HWY_ONCE.
#include "tracer/wide/kernels.h"

// What the sets left out would add (SSSE3, AVX-512 of Ice Lake) is not used here; vectors of SVE have no size
// to the compiler, so that nothing can hold them.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
// The bug for which Highway gives up its portable 128-bit vectors is in 16-bit multiplication (GCC 106322),
// which is not used here either.
#define HWY_BROKEN_EMU128 0
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/wide/kernels.cpp"
#include <hwy/foreach_target.h>

#include "tracer/wide/packets-inl.h"
#include "tracer/wide/stream-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raysweep {
namespace HWY_NAMESPACE {

template <class Method, bool any>
HWY_ATTR void run_single(const WideGeometry<Method, lane_count>& geometry, const RayBatch& rays,
                         HitBatch& hits, KernelScratch& scratch) {
  scratch.left_over.clear();
  scratch.groups.clear();
  for (size_t i = 0; i < rays.size; i += packet_size) scratch.groups.push_back(static_cast<uint32_t>(i));
  Stream<Method, any>(geometry, rays, hits, scratch).run();
}

template <class Method, bool any>
HWY_ATTR void run_packets(const WideGeometry<Method, lane_count>& geometry, const RayBatch& rays,
                          HitBatch& hits, KernelScratch& scratch) {
  scratch.left_over.clear();
  scratch.groups.clear();
  Packets<Method, any>(geometry, rays, hits, scratch).run();
  Stream<Method, any>(geometry, rays, hits, scratch).run();
}

template <class Method>
BatchKernels<Method, lane_count> kernels() {
  return {{&run_single<Method, false>, &run_single<Method, true>},
          {&run_packets<Method, false>, &run_packets<Method, true>}};
}

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <algorithm>
#include <array>

#include "tracer/wide/isa.h"

namespace raysweep {

namespace {

struct Target {
  Isa isa;
  int64_t bit;
};

/// Best first.
constexpr auto targets = std::to_array<Target>({
#if (HWY_TARGETS & HWY_AVX3) != 0
  {{"avx512", "AVX-512 (F, BW, CD, DQ, VL): nodes and blocks of 8", 8}, HWY_AVX3},
#endif
#if (HWY_TARGETS & HWY_AVX2) != 0
      {{"avx2", "AVX2 with FMA: nodes and blocks of 8", 8}, HWY_AVX2},
#endif
#if (HWY_TARGETS & HWY_SSE4) != 0
      {{"sse4", "SSE4.2: nodes and blocks of 4", 4}, HWY_SSE4},
#endif
#if (HWY_TARGETS & HWY_NEON) != 0
      {{"neon", "Advanced SIMD: nodes and blocks of 4", 4}, HWY_NEON},
#endif
#if (HWY_TARGETS & HWY_EMU128) != 0
      {{"baseline", "what every processor of this architecture has: nodes and blocks of 4", 4}, HWY_EMU128},
#endif
});

bool runs_here(const Target& target) {
  // What the whole program is compiled for runs wherever it does.
  return target.bit == HWY_STATIC_TARGET || (hwy::SupportedTargets() & target.bit) != 0;
}

}  // namespace

std::span<const Isa> built_isas() {
  static const std::vector<Isa> list = [] {
    std::vector<Isa> all;
    for (const Target& target : targets) all.push_back(target.isa);
    return all;
  }();
  return list;
}

bool runs_here(std::string_view isa) {
  return std::ranges::any_of(targets, [&](const Target& t) { return t.isa.name == isa && runs_here(t); });
}

std::string_view best_isa() {
  return std::ranges::find_if(targets, [](const Target& t) { return runs_here(t); })->isa.name;
}

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

template BatchKernels<MollerTrumbore, 4> kernels_for(std::string_view);
template BatchKernels<MollerTrumbore, 8> kernels_for(std::string_view);
template BatchKernels<Morozov, 4> kernels_for(std::string_view);
template BatchKernels<Morozov, 8> kernels_for(std::string_view);
template BatchKernels<WoopWatertight, 4> kernels_for(std::string_view);
template BatchKernels<WoopWatertight, 8> kernels_for(std::string_view);

}  // namespace raysweep

#endif
