// Rays and triangles with whole coordinates, and where they meet without rounding.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <random>

#include "tracer/intersect/intersector.h"

namespace raysweep {

__extension__ using Int128 = __int128;

/// Whole numbers up to 2³⁰: then no determinant below exceeds 6·2⁹³.
using Lattice3 = std::array<int64_t, 3>;

inline Lattice3 operator+(const Lattice3& a, const Lattice3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Lattice3 operator-(const Lattice3& a, const Lattice3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Lattice3 operator*(int64_t s, const Lattice3& a) { return {s * a[0], s * a[1], s * a[2]}; }

struct LatticePair {
  Lattice3 a, b, c, origin, direction;

  /// With numbers of type `T`, divided by `unit`, which leaves t and weights what they are.
  template <class T>
  [[nodiscard]] Triangle<T> triangle(int64_t unit = 1) const {
    return {as<T>(a, unit), as<T>(b, unit), as<T>(c, unit)};
  }
  template <class T>
  [[nodiscard]] Ray<T> ray(int64_t unit = 1) const {
    return {as<T>(origin, unit), as<T>(direction, unit)};
  }

 private:
  template <class T>
  [[nodiscard]] static Vec3<T> as(const Lattice3& x, int64_t unit) {
    const auto scaled = [&](int64_t value) { return static_cast<T>(value) / static_cast<T>(unit); };
    return {scaled(x[0]), scaled(x[1]), scaled(x[2])};
  }
};

/// Of the columns a, b, c.
inline Int128 determinant(const Lattice3& a, const Lattice3& b, const Lattice3& c) {
  const auto minor = [&](int i, int j) { return Int128(b[i]) * c[j] - Int128(b[j]) * c[i]; };
  return a[0] * minor(1, 2) - a[1] * minor(0, 2) + a[2] * minor(0, 1);
}

/// Cramer's rule for O + t·D = A + β·AB + γ·AC, with the determinant made positive; 0 if there is no single
/// point.
struct Cramer {
  Int128 det, t, beta, gamma;

  explicit Cramer(const LatticePair& pair) {
    const Lattice3 ab = pair.b - pair.a, ac = pair.c - pair.a, ao = pair.origin - pair.a;
    const Lattice3 back = -1 * pair.direction;
    det = determinant(back, ab, ac);
    const int sign = det < 0 ? -1 : 1;
    det *= sign;
    t = sign * determinant(ao, ab, ac);
    beta = sign * determinant(back, ao, ac);
    gamma = sign * determinant(back, ab, ao);
  }
  [[nodiscard]] Int128 alpha() const { return det - beta - gamma; }
  [[nodiscard]] bool is_on_border() const {
    return is_hit(false, 0) && (alpha() == 0 || beta == 0 || gamma == 0);
  }
  /// 0 < t, and t < t_max unless that is 0, for none.
  [[nodiscard]] bool is_hit(bool strict, int64_t t_max) const {
    const Int128 least = strict ? 1 : 0;
    return det > 0 && t > 0 && (t_max == 0 || t < t_max * det) && alpha() >= least && beta >= least &&
           gamma >= least;
  }
};

class LatticeRandom {
 public:
  explicit LatticeRandom(uint64_t seed) : random_(seed) {}

  /// From 0 to count − 1.
  int64_t below(int64_t count) { return static_cast<int64_t>(random_() % static_cast<uint64_t>(count)); }
  Lattice3 point(int64_t greatest) {
    const auto number = [&] { return below(2 * greatest + 1) - greatest; };
    const int64_t x = number(), y = number();
    return {x, y, number()};
  }

  /// Pairs of which many are special: rays to corners and to the middle of edges, in or parallel to the
  /// plane, from it, away from it; triangles without area.
  LatticePair small_pair() {
    LatticePair pair{2 * point(2), 2 * point(2), 2 * point(2), point(4), point(3)};
    const int64_t shape = below(16);
    if (shape == 0) pair.c = below(2) == 0 ? pair.a : pair.b;
    if (shape == 1) pair.c = 2 * pair.b - pair.a;
    const Lattice3 middle = {(pair.a[0] + pair.b[0]) / 2, (pair.a[1] + pair.b[1]) / 2,
                             (pair.a[2] + pair.b[2]) / 2};
    const std::array targets = {pair.a, pair.b, pair.c, middle};
    if (below(2) == 0) pair.origin = targets[below(4)] - (below(4) - 1) * pair.direction;
    if (below(16) == 0) pair.direction = below(3) * (pair.b - pair.a) + below(3) * (pair.c - pair.a);
    // Turned so that every corner and every edge has its turn.
    for (int64_t turns = below(3); turns > 0; --turns) {
      const Lattice3 first = pair.a;
      pair.a = pair.b;
      pair.b = pair.c;
      pair.c = first;
    }
    return pair;
  }

  /// Coordinates up to `unit`, every second ray aimed at a point in the triangle's box.
  LatticePair large_pair(int64_t unit) {
    LatticePair pair{point(unit), point(unit), point(unit), point(unit), point(unit)};
    if (below(2) == 0) {
      const int64_t b = below(1024), c = below(1024 - b);
      for (int i = 0; i < 3; ++i) {
        const int64_t target = pair.a[i] + (b * (pair.b[i] - pair.a[i]) + c * (pair.c[i] - pair.a[i])) / 1024;
        pair.direction[i] = target - pair.origin[i];
      }
    }
    return pair;
  }

 private:
  std::mt19937_64 random_;
};

}  // namespace raysweep
