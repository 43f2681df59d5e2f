// Integers for exact arithmetic: of 128 bits, and of any number of bits.
#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <utility>

namespace raysweep {

__extension__ using Int128 = __int128;

/// GMP's integers with the operators of the formulas alone. Without `==`: Vec3 would compare them at compile
/// time, which Clang 14 rejects.
class BigInteger {
 public:
  BigInteger() = default;
  explicit BigInteger(mpz_class n) : n_(std::move(n)) {}

  friend BigInteger operator+(const BigInteger& a, const BigInteger& b) { return BigInteger(a.n_ + b.n_); }
  friend BigInteger operator-(const BigInteger& a, const BigInteger& b) { return BigInteger(a.n_ - b.n_); }
  friend BigInteger operator*(const BigInteger& a, const BigInteger& b) { return BigInteger(a.n_ * b.n_); }

  [[nodiscard]] const mpz_class& value() const { return n_; }

 private:
  mpz_class n_;
};

/// −1, 0 or 1.
[[nodiscard]] inline int sign(Int128 n) { return (n > 0 ? 1 : 0) - (n < 0 ? 1 : 0); }
[[nodiscard]] inline int sign(const mpz_class& n) { return sgn(n); }
[[nodiscard]] inline int sign(const BigInteger& n) { return sgn(n.value()); }

[[nodiscard]] inline mpz_class to_mpz(const BigInteger& n) { return n.value(); }
[[nodiscard]] inline mpz_class to_mpz(Int128 n) {
  const mpz_class high(static_cast<long>(n >> 64)), low(static_cast<unsigned long>(n));
  return mpz_class(high << 64) + low;
}

/// `n = mantissa·2^shift`, which must fit.
inline void assign(Int128& n, int64_t mantissa, unsigned shift) { n = mantissa * (Int128{1} << shift); }
inline void assign(BigInteger& n, int64_t mantissa, unsigned shift) {
  n = BigInteger(mpz_class(mpz_class(static_cast<long>(mantissa)) << shift));
}

/// n/d by three roundings, each of half an ulp of 64 bits at most. Both are converted.
[[nodiscard]] inline long double ratio(Int128 n, Int128 d) {
  return static_cast<long double>(n) / static_cast<long double>(d);
}
/// n/d by one rounding of a quotient of at least 67 bits.
[[nodiscard]] long double ratio(const BigInteger& n, const BigInteger& d);

}  // namespace raysweep
