// Numbers that a formula computes with as it does with T, and that know how far rounding may have led astray.
#pragma once

#include <cmath>
#include <concepts>
#include <limits>

namespace raysweep {

/// What T makes of a formula, operation by operation, with a bound of its distance from what real numbers
/// make of it: Wilkinson's running error analysis (Higham 2002, "Accuracy and stability of numerical
/// algorithms", 3.3). Let u be half an ulp of 1 and fl(x) the number of T nearest to x. Then
/// |fl(x) − x| ≤ u·|fl(x)|, and in products and quotients below the normal numbers half of the smallest
/// number besides; sums there are exact. What an operation's operands are off by it hands on as the
/// derivative says, for products and quotients with the second order. A value that is not finite may be off
/// by anything. T is float or double; the bound has digits and exponents for both and is rounded up.
template <std::floating_point T>
class Rounded {
 public:
  constexpr Rounded() = default;
  /// A literal of a formula.
  template <class Literal>
  requires std::is_arithmetic_v<Literal>
  // NOLINTNEXTLINE(google-explicit-constructor): formulas write V(0) and 2 * x alike
  constexpr Rounded(Literal x)
      : value_(static_cast<T>(x)), error_(magnitude(static_cast<long double>(value_) - x)) {}

  [[nodiscard]] constexpr T value() const { return value_; }
  /// |value − exact| is at most this; infinity where nothing is known.
  [[nodiscard]] constexpr long double error() const { return error_; }

  friend constexpr Rounded operator+(const Rounded& a, const Rounded& b) {
    return sum(a.value_ + b.value_, a, b);
  }
  friend constexpr Rounded operator-(const Rounded& a, const Rounded& b) {
    return sum(a.value_ - b.value_, a, b);
  }
  friend constexpr Rounded operator-(const Rounded& a) { return Rounded(-a.value_, a.error_); }
  friend constexpr Rounded operator*(const Rounded& a, const Rounded& b) {
    const long double inherited = a.size() * b.error_ + b.size() * a.error_ + a.error_ * b.error_;
    const T value = a.value_ * b.value_;
    return Rounded(value, inherited + rounding(value) + underflow(value));
  }
  /// |x/y − x*/y*| = |x·(y* − y) + y·(x − x*)| / |y·y*|, with |y*| ≥ |y| − error.
  friend constexpr Rounded operator/(const Rounded& x, const Rounded& y) {
    const long double least = y.size() - y.error_;
    const T value = x.value_ / y.value_;
    if (!(least > 0)) return Rounded(value, unknown);
    const long double inherited = (x.size() * y.error_ + y.size() * x.error_) / (y.size() * least);
    return Rounded(value, inherited + rounding(value) + underflow(value));
  }

  // As T decides.
  friend constexpr bool operator<(const Rounded& a, const Rounded& b) { return a.value_ < b.value_; }
  friend constexpr bool operator>(const Rounded& a, const Rounded& b) { return a.value_ > b.value_; }
  friend constexpr bool operator<=(const Rounded& a, const Rounded& b) { return a.value_ <= b.value_; }
  friend constexpr bool operator>=(const Rounded& a, const Rounded& b) { return a.value_ >= b.value_; }

  /// `yes` where `mask` holds, else `no`.
  friend constexpr Rounded select(bool mask, const Rounded& yes, const Rounded& no) {
    return mask ? yes : no;
  }
  /// The greatest finite number.
  friend constexpr Rounded greatest(const Rounded& /*type*/) { return std::numeric_limits<T>::max(); }

 private:
  static constexpr long double unknown = std::numeric_limits<long double>::infinity();
  static_assert(std::numeric_limits<long double>::max_exponent >= 16384,
                "long double must be wider than double");

  /// A bound is a sum of at most eight numbers that are not negative, each of at most three factors: twelve
  /// roundings of the bound's own make it too small by less than this.
  static constexpr long double upwards = 1 + 16 * std::numeric_limits<long double>::epsilon();

  constexpr Rounded(T value, long double error) : value_(value), error_(unknown) {
    // Infinity times 0 is NaN: nothing is known either. What is not finite has an infinite rounding, or NaN.
    if (error < unknown) error_ = error * upwards;
  }
  [[nodiscard]] static constexpr Rounded sum(T value, const Rounded& a, const Rounded& b) {
    return Rounded(value, a.error_ + b.error_ + rounding(value));
  }

  [[nodiscard]] static constexpr long double magnitude(long double x) { return x < 0 ? -x : x; }
  [[nodiscard]] constexpr long double size() const { return magnitude(value_); }
  [[nodiscard]] static constexpr long double rounding(T value) {
    return magnitude(value) * (std::numeric_limits<T>::epsilon() / 2);
  }
  [[nodiscard]] static constexpr long double underflow(T value) {
    const bool is_normal = magnitude(value) >= std::numeric_limits<T>::min();
    return is_normal ? 0 : static_cast<long double>(std::numeric_limits<T>::denorm_min()) / 2;
  }

  T value_ = 0;
  long double error_ = 0;
};

}  // namespace raysweep
