// Random draws that are the same on every standard library.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>

namespace raysweep {

/// The engine is fixed by the C++ standard; its distributions are not, hence our own.
class Random {
 public:
  explicit Random(uint64_t seed) : bits_(seed) {}

  /// 0 to count − 1, each as often as the others. `count` must not be 0.
  [[nodiscard]] size_t index(size_t count);
  /// −1 or 1.
  [[nodiscard]] double sign() { return (bits_() >> 63) != 0 ? 1 : -1; }

 private:
  std::mt19937_64 bits_;
};

}  // namespace raysweep
