// The dot product of four floats with four others by one instruction, dpps of SSE4.1, against others: what
// Morozov 2011, 5.9.2, compares. All add in the order that dpps does, (0 + 1) + (2 + 3).
#include <fmt/format.h>

#include <bit>

#include "experiments/kernels/highway_loops.h"
#include "experiments/kernels/keep.h"
#include "experiments/kernels/small_kernel.h"
#include "results/statistics/random.h"

#if defined(__x86_64__)
#include <immintrin.h>
#define RAYSWEEP_X86
#endif

namespace raysweep {

namespace {

// Both lists are 16 KB together: they stay in the first cache.
constexpr uint64_t product_count = 512;

using Loop = void (*)(const float* a, const float* b, uint64_t count, float* products);

void scalar_products(const float* a, const float* b, uint64_t count, float* products) {
  for (uint64_t i = 0; i < count; ++i, a += 4, b += 4)
    products[i] = (a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3]);
}

#ifdef RAYSWEEP_X86

[[gnu::target("sse4.1")]] void dpps_products(const float* a, const float* b, uint64_t count,
                                             float* products) {
  constexpr int all_into_first = 0xF1;
  for (uint64_t i = 0; i < count; ++i)
    products[i] = _mm_cvtss_f32(_mm_dp_ps(_mm_loadu_ps(a + 4 * i), _mm_loadu_ps(b + 4 * i), all_into_first));
}

[[gnu::target("sse4.1")]] void shuffled_products(const float* a, const float* b, uint64_t count,
                                                 float* products) {
  for (uint64_t i = 0; i < count; ++i) {
    const __m128 product = _mm_mul_ps(_mm_loadu_ps(a + 4 * i), _mm_loadu_ps(b + 4 * i));
    const __m128 pairs = _mm_add_ps(product, _mm_movehdup_ps(product));
    products[i] = _mm_cvtss_f32(_mm_add_ss(pairs, _mm_movehl_ps(pairs, pairs)));
  }
}

Loop loop_of(const std::string& dot) {
  if (dot == "dpps") return dpps_products;
  if (dot == "shuffles") return shuffled_products;
  return dot == "highway" ? highway_dot_products : scalar_products;
}

std::string why_not(const FactorValues& values) {
  const std::string& dot = values.at("dot");
  if (dot != "dpps" && dot != "shuffles") return {};
  return __builtin_cpu_supports("sse4.1") != 0 ? "" : "this processor has no SSE4.1";
}

#else

Loop loop_of(const std::string& dot) { return dot == "highway" ? highway_dot_products : scalar_products; }

std::string why_not(const FactorValues& values) {
  const std::string& dot = values.at("dot");
  return dot == "dpps" || dot == "shuffles" ? "the instructions of SSE4.1 are x86's" : "";
}

#endif

class DotPass : public SmallPass {
 public:
  DotPass(Loop loop, uint64_t seed) : loop_(loop), products_(product_count) {
    Random random(seed);
    const auto draw = [&] {
      return static_cast<float>(static_cast<double>(random.index(1U << 24U)) / (1U << 23U) - 1);
    };
    for (uint64_t i = 0; i < 4 * product_count; ++i) {
      a_.push_back(draw());
      b_.push_back(draw());
    }
  }

  [[nodiscard]] uint64_t operations() const override { return product_count; }
  double run() override {
    loop_(a_.data(), b_.data(), product_count, products_.data());
    keep(products_);
    return static_cast<double>(products_.back());
  }
  [[nodiscard]] std::string why_wrong() override {
    std::vector<float> right(product_count);
    scalar_products(a_.data(), b_.data(), product_count, right.data());
    run();
    for (size_t i = 0; i < product_count; ++i) {
      if (std::bit_cast<uint32_t>(products_[i]) != std::bit_cast<uint32_t>(right[i]))
        return fmt::format("product {} is {}, where {} is right", i, products_[i], right[i]);
    }
    return {};
  }

 private:
  Loop loop_;
  std::vector<float> a_, b_, products_;
};

std::unique_ptr<SmallPass> prepare_dot_products(const FactorValues& values, uint64_t seed) {
  return std::make_unique<DotPass>(loop_of(values.at("dot")), seed);
}

}  // namespace

SmallKernel dot_products_kernel() {
  return {"dot_products",
          "a dot product of four floats with four others, of lists of them",
          "product",
          {{"dot", {"dpps", "shuffles", "highway", "scalar"}}},
          why_not,
          prepare_dot_products,
          // Both passes and what is made for them are short beside samples.
          [](const FactorValues&) { return 0.0; }};
}

}  // namespace raysweep
