#include "tracer/wide/isa.h"

#include <algorithm>
#include <array>
#include <vector>

#include "tracer/targets.h"

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

}  // namespace raysweep
