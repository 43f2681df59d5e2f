#include "experiments/overhead/busy_work.h"

#include <chrono>
#include <vector>

#include "results/statistics/statistics.h"

namespace raysweep {

namespace {

/// No instruction goes on beyond this one before all earlier ones are done.
inline void wait_for_all_before() {
#if defined(__x86_64__)
  __builtin_ia32_lfence();
#elif defined(__aarch64__)
  asm volatile("isb" ::: "memory");
#endif
}

template <class Call>
double median_nanoseconds(int calls, Call call) {
  std::vector<double> samples(200);
  for (double& sample : samples) {
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < calls; ++i) call();
    const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - begin;
    sample = taken.count() / calls;
  }
  return median(samples);
}

}  // namespace

[[gnu::noinline]] void busy_work(std::uint64_t iterations) noexcept {
  wait_for_all_before();
  std::uint64_t x = iterations;
  for (std::uint64_t i = 0; i < iterations; ++i) {
    x = x * 6364136223846793005u + 1442695040888963407u;  // Knuth's MMIX generator: any odd factor would do
    asm volatile("" : "+r"(x));                           // the compiler must not know what came out
  }
  wait_for_all_before();
}

WorkSpeed measure_work_speed() {
  constexpr std::uint64_t long_work = 50'000;
  const double call = median_nanoseconds(5'000, [] { busy_work(0); });
  const double whole = median_nanoseconds(1, [] { busy_work(long_work); });
  return {call, (whole - call) / static_cast<double>(long_work)};
}

Body busy_items(std::uint64_t iterations) {
  return [iterations](size_t begin, size_t end, int) {
    for (size_t i = begin; i < end; ++i) busy_work(iterations);
  };
}

}  // namespace raysweep
