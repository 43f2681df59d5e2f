// Numbers that know how wrong they may be.
#pragma once

#include <cmath>
#include <limits>

namespace raysweep {

/// A value and a bound of its error. The formats of 80 and 128 bits have 15 bits of exponent: products of six
/// doubles neither overflow nor underflow. Each operation adds twice the rounding error that it may make,
/// and of the bound's own rounding errors a factor of 2 in `is_certain` takes care.
class Bounded {
 public:
  // NOLINTNEXTLINE(google-explicit-constructor): literals of formulas
  Bounded(long double exact = 0) : value_(exact) {}

  friend Bounded operator+(const Bounded& a, const Bounded& b) {
    return rounded(a.value_ + b.value_, a.error_ + b.error_);
  }
  friend Bounded operator-(const Bounded& a, const Bounded& b) {
    return rounded(a.value_ - b.value_, a.error_ + b.error_);
  }
  friend Bounded operator*(const Bounded& a, const Bounded& b) {
    return rounded(a.value_ * b.value_,
                   std::abs(a.value_) * b.error_ + std::abs(b.value_) * a.error_ + a.error_ * b.error_);
  }

  /// Whether `sign` is that of the exact value, which is then not 0.
  [[nodiscard]] bool is_certain() const { return std::abs(value_) > 2 * error_; }
  [[nodiscard]] int sign() const { return value_ > 0 ? 1 : -1; }

 private:
  static_assert(std::numeric_limits<long double>::max_exponent >= 16384,
                "long double must be wider than double");
  static Bounded rounded(long double value, long double inherited) {
    Bounded result(value);
    result.error_ = inherited + std::abs(value) * std::numeric_limits<long double>::epsilon();
    return result;
  }

  long double value_;
  long double error_ = 0;
};

}  // namespace raysweep
