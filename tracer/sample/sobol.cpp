#include <utility>

#include "tracer/sample/point_sets.h"

namespace raysweep {

namespace {

uint32_t reverse_bits(uint32_t x) {
  x = (x >> 16) | (x << 16);
  x = ((x & 0xff00ff00u) >> 8) | ((x & 0x00ff00ffu) << 8);
  x = ((x & 0xf0f0f0f0u) >> 4) | ((x & 0x0f0f0f0fu) << 4);
  x = ((x & 0xccccccccu) >> 2) | ((x & 0x33333333u) << 2);
  return ((x & 0xaaaaaaaau) >> 1) | ((x & 0x55555555u) << 1);
}

/// The second dimension, as a fraction of 2³²: its polynomial is x + 1, so each direction number is the one
/// before times (1 + half) without carry (Joe & Kuo 2008). The first dimension is the index mirrored.
uint32_t second_dimension(uint32_t index) {
  uint32_t sum = 0;
  for (uint32_t direction = 1u << 31; index > 0; index >>= 1, direction ^= direction >> 1) {
    if (index & 1) sum ^= direction;
  }
  return sum;
}

/// Owen's nested uniform scrambling (1995): whether a digit flips depends on all digits above it. The hash
/// (Laine & Karras, "Stratified sampling for stochastic transparency", 2011; constants by Burley, "Practical
/// hash-based Owen scrambling", JCGT 9(4), 2020) lets each bit depend on lower ones only, since x · even adds
/// multiples of a bit's double; mirrored bits turn lower into higher.
uint32_t owen_scramble(uint32_t fraction, uint32_t seed) {
  uint32_t x = reverse_bits(fraction) + seed;
  for (const uint32_t even : {0x6c50b47cu, 0xb82f1e52u, 0xc7afe638u, 0x8d22f6e6u}) x ^= x * even;
  return reverse_bits(x);
}

/// One seed a dimension, far apart even for neighbouring seeds: the finaliser of SplitMix64 (Steele, Lea &
/// Flood 2014).
std::pair<uint32_t, uint32_t> seeds_of_dimensions(uint32_t seed) {
  uint64_t z = seed + 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  z ^= z >> 31;
  return {static_cast<uint32_t>(z), static_cast<uint32_t>(z >> 32)};
}

/// 24 bits: such a number is below 1 in float too.
double to_unit(uint32_t fraction) { return (fraction >> 8) * 0x1p-24; }

}  // namespace

/// Sobol 1967. Of 2^k points each of 2^k boxes of equal size holds one, whether they are rows, columns or any
/// halvings between; scrambling keeps that.
std::vector<Subpixel> make_sobol(int count, uint32_t seed) {
  const auto [x_seed, y_seed] = seeds_of_dimensions(seed);
  std::vector<Subpixel> points;
  for (uint32_t i = 0; i < static_cast<uint32_t>(count); ++i) {
    points.push_back({to_unit(owen_scramble(reverse_bits(i), x_seed)),
                      to_unit(owen_scramble(second_dimension(i), y_seed))});
  }
  return points;
}

}  // namespace raysweep
