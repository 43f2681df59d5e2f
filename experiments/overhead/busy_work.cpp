#include "experiments/overhead/busy_work.h"

#include <chrono>
#include <vector>

#include "results/statistics.h"

namespace raysweep {

namespace {

thread_local std::uint64_t last = 0;

}  // namespace

[[gnu::noinline]] void busy_work(std::uint64_t iterations) noexcept {
  std::uint64_t x = last;
  for (std::uint64_t i = 0; i < iterations; ++i) {
    x = x * 6364136223846793005u + 1442695040888963407u;  // Knuth's MMIX generator: any odd factor would do
    asm volatile("" : "+r"(x));                           // the compiler must not know what came out
  }
  last = x;
}

double nanoseconds_of_an_iteration() {
  constexpr std::uint64_t batch = 100'000;
  std::vector<double> samples(200);
  for (double& sample : samples) {
    const auto begin = std::chrono::steady_clock::now();
    busy_work(batch);
    const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - begin;
    sample = taken.count() / static_cast<double>(batch);
  }
  return median(samples);
}

Body busy_items(std::uint64_t iterations) {
  return [iterations](size_t begin, size_t end, int) {
    for (size_t i = begin; i < end; ++i) busy_work(iterations);
  };
}

}  // namespace raysweep
