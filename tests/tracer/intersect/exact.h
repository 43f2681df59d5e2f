// Rational numbers without rounding, with what a formula asks of its numbers (tracer/intersect/value.h).
#pragma once

#include <gmpxx.h>

#include <optional>

#include "tracer/intersect/value.h"

namespace raysweep {

/// A rational number, or nothing: what a division by zero gives, which every operation hands on and no
/// comparison accepts.
class Exact {
 public:
  Exact() = default;
  explicit Exact(long value) : value_(mpq_class(value)) {}

  /// Throws `std::bad_optional_access` if it is nothing.
  [[nodiscard]] const mpq_class& value() const { return value_.value(); }

  friend Exact operator+(const Exact& a, const Exact& b) {
    return combined(a, b, [](const mpq_class& x, const mpq_class& y) { return mpq_class(x + y); });
  }
  friend Exact operator-(const Exact& a, const Exact& b) {
    return combined(a, b, [](const mpq_class& x, const mpq_class& y) { return mpq_class(x - y); });
  }
  friend Exact operator*(const Exact& a, const Exact& b) {
    return combined(a, b, [](const mpq_class& x, const mpq_class& y) { return mpq_class(x * y); });
  }
  friend Exact operator/(const Exact& a, const Exact& b) {
    if (b.value_ && sgn(*b.value_) == 0) return Exact(std::nullopt);
    return combined(a, b, [](const mpq_class& x, const mpq_class& y) { return mpq_class(x / y); });
  }
  friend Exact operator-(const Exact& a) { return Exact() - a; }

  friend bool operator<(const Exact& a, const Exact& b) {
    return a.value_ && b.value_ && *a.value_ < *b.value_;
  }
  friend bool operator>(const Exact& a, const Exact& b) { return b < a; }
  friend bool operator<=(const Exact& a, const Exact& b) {
    return a.value_ && b.value_ && *a.value_ <= *b.value_;
  }
  friend bool operator>=(const Exact& a, const Exact& b) { return b <= a; }
  /// A template, since Vec3 compares in a constexpr function, and rationals do not in any other.
  template <std::same_as<Exact> E>
  friend constexpr bool operator==(const E& a, const E& b) {
    return a.value_ && b.value_ && *a.value_ == *b.value_;
  }

  friend Exact select(bool mask, const Exact& yes, const Exact& no) { return mask ? yes : no; }
  /// Beyond every number of these tests.
  friend Exact greatest(const Exact& /*type*/) { return Exact(mpq_class(mpz_class(1) << 1000)); }
  friend Exact not_given(const Exact& /*type*/) { return Exact(std::nullopt); }

 private:
  explicit Exact(std::optional<mpq_class> value) : value_(std::move(value)) {}

  template <class Operation>
  [[nodiscard]] static Exact combined(const Exact& a, const Exact& b, const Operation& operation) {
    if (!a.value_ || !b.value_) return Exact(std::nullopt);
    return Exact(operation(*a.value_, *b.value_));
  }

  std::optional<mpq_class> value_ = mpq_class();
};

}  // namespace raysweep
