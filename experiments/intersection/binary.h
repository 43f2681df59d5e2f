// Floating-point numbers as integers times a power of 2.
#pragma once

#include <algorithm>
#include <bit>
#include <climits>
#include <cstdint>
#include <initializer_list>

#include "experiments/intersection/integers.h"
#include "tracer/math/vec3.h"

namespace raysweep {

/// `mantissa·2^exponent`, the mantissa odd or 0.
struct Binary {
  int64_t mantissa = 0;
  int exponent = 0;

  Binary() = default;
  /// `value` is finite. Fields of IEEE 754's binary64; subnormals have the exponent of field 1 without its
  /// leading bit.
  explicit Binary(double value) {
    const auto bits = std::bit_cast<uint64_t>(value);
    const int field = static_cast<int>(bits >> 52 & 0x7ff);
    const uint64_t digits = (bits & ((uint64_t{1} << 52) - 1)) | (field == 0 ? 0 : uint64_t{1} << 52);
    if (digits == 0) return;
    const int zeros = std::countr_zero(digits);
    const auto odd = static_cast<int64_t>(digits >> zeros);
    mantissa = (bits >> 63) != 0 ? -odd : odd;
    exponent = std::max(field, 1) - 1075 + zeros;
  }
  /// One more than the exponent of the leading bit. Not of 0.
  [[nodiscard]] int top() const {
    const auto magnitude = static_cast<uint64_t>(mantissa < 0 ? -mantissa : mantissa);
    return exponent + static_cast<int>(std::bit_width(magnitude));
  }
};

/// The coarsest grid `n·2^exponent` on which some vectors lie.
struct Grid {
  int exponent = 0;
  int bits = 0;  // every |n| < 2^bits

  Grid(std::initializer_list<Vec3<Binary>> vectors) {
    int least = INT_MAX, top = INT_MIN;
    for (const Vec3<Binary>& v : vectors) {
      for (const Binary& number : {v.x, v.y, v.z}) {
        if (number.mantissa == 0) continue;
        least = std::min(least, number.exponent);
        top = std::max(top, number.top());
      }
    }
    if (least == INT_MAX) return;
    exponent = least;
    bits = top - least;
  }
};

/// The coordinates on `grid`, which must hold them, as integers of a type that must, too.
template <class Integer>
[[nodiscard]] Vec3<Integer> on_grid(const Grid& grid, const Vec3<Binary>& v) {
  const auto n = [&](const Binary& number) {
    Integer result{};
    if (number.mantissa != 0)
      assign(result, number.mantissa, static_cast<unsigned>(number.exponent - grid.exponent));
    return result;
  };
  return {n(v.x), n(v.y), n(v.z)};
}

}  // namespace raysweep
