#include "experiments/intersection/integers.h"

#include <cmath>

namespace raysweep {

static_assert(sizeof(long) == 8, "GMP takes long: a mantissa has to fit");

long double ratio(const BigInteger& numerator, const BigInteger& denominator) {
  const mpz_class &n = numerator.value(), &d = denominator.value();
  if (n == 0) return 0;
  const auto bits = [](const mpz_class& x) { return static_cast<long>(mpz_sizeinbase(x.get_mpz_t(), 2)); };
  // The quotient has 68 or 69 bits, and what is cut off is below 2⁻⁶⁷ of it.
  const long shift = 68 - bits(n) + bits(d);
  const mpz_class up = shift > 0 ? mpz_class(n << static_cast<unsigned long>(shift)) : n;
  const mpz_class down = shift < 0 ? mpz_class(d << static_cast<unsigned long>(-shift)) : d;
  const mpz_class quotient = abs(mpz_class(up / down));
  const mpz_class high = quotient >> 32, low = quotient & 0xffffffffu;
  const long double whole =
      static_cast<long double>(high.get_ui()) * 0x1p32l + static_cast<long double>(low.get_ui());
  return std::scalbn(sgn(n) == sgn(d) ? whole : -whole, static_cast<int>(-shift));
}

}  // namespace raysweep
