#include <cmath>
#include <numeric>
#include <utility>

#include "tracer/sample/point_sets.h"

namespace raysweep {

namespace {

/// The points (i, i·generator mod modulus) of a square of side `modulus`, repeated without end.
struct Lattice {
  long long modulus = 1, generator = 1;
  long long distance = 0;  // between nearest points, squared
};

/// The squared length of the shortest vector but 0, by Gauss's reduction of the basis (1, g), (0, m).
long long shortest_squared(long long m, long long g) {
  std::pair a{1LL, g}, b{0LL, m};
  const auto dot = [](const auto& p, const auto& q) { return p.first * q.first + p.second * q.second; };
  while (true) {
    const long long times = std::llround(static_cast<double>(dot(a, b)) / static_cast<double>(dot(a, a)));
    b = {b.first - times * a.first, b.second - times * a.second};
    if (dot(b, b) >= dot(a, a)) return dot(a, a);
    std::swap(a, b);
  }
}

/// The lattice of one modulus whose points keep farthest apart; of equal ones the one with the largest
/// generator, which for 5 is 3.
Lattice best_lattice(long long modulus) {
  Lattice best;
  for (long long g = 1; g < modulus; ++g) {
    if (std::gcd(g, modulus) != 1) continue;
    const long long distance = shortest_squared(modulus, g);
    if (distance >= best.distance) best = {modulus, g, distance};
  }
  return best;
}

}  // namespace

/// A rank-1 lattice (Korobov 1959): in units of 1/count, the i-th column holds one point, in row
/// i·generator mod count; a generator without a common divisor with the modulus gives every point a row of
/// its own, so that all x and all y are evenly spaced and the mean is the centre. Of modulus `count`, and of
/// modulus `count` + 1 without the point 0, the lattice is taken whose points keep farther apart for their
/// density. 4 points come from modulus 5 and are the rotated grid of four rooks that graphics hardware uses:
/// the regular grid, turned by atan(1/2).
std::vector<Subpixel> make_rotated_grid(int count) {
  const Lattice whole = best_lattice(count), holed = best_lattice(count + 1LL);
  const bool hole = holed.distance * whole.modulus >= whole.distance * holed.modulus;
  const Lattice& lattice = hole ? holed : whole;
  const int first = hole ? 1 : 0;  // the point 0, which has the column 0 and the row 0 for itself
  std::vector<Subpixel> points;
  for (int column = 0; column < count; ++column) {
    const auto row = static_cast<double>((column + first) * lattice.generator % lattice.modulus - first);
    points.push_back({(column + 0.5) / count, (row + 0.5) / count});
  }
  return points;
}

}  // namespace raysweep
