#include "experiments/intersection/oracle.h"

#include <optional>
#include <type_traits>

#include "experiments/intersection/binary.h"
#include "experiments/intersection/bounded.h"
#include "experiments/intersection/integers.h"
#include "experiments/intersection/meeting.h"

namespace raysweep {

namespace {

/// For coordinates of k bits differences have k + 1, their cross products 2k + 3, and products of three, of
/// which three are summed, 3k + 5 and a sign: 126 at most.
constexpr int lattice_bits = 40;

/// A ray and a triangle as integers: places on one grid, the direction on another, which only scales t.
struct Problem {
  Vec3<Binary> origin, direction, a, b, c;
  std::optional<Binary> t_max;  // none: infinite
  Grid places, directions;

  template <class T>
  Problem(const Ray<T>& ray, const Triangle<T>& triangle, T limit)
      : origin(binary(ray.origin)),
        direction(binary(ray.direction)),
        a(binary(triangle.a)),
        b(binary(triangle.b)),
        c(binary(triangle.c)),
        t_max(std::isinf(limit) ? std::nullopt : std::optional(Binary(limit))),
        places{origin, a, b, c},
        directions{direction} {}

  template <class Integer>
  [[nodiscard]] Meeting<Integer> meeting() const {
    return {on_grid<Integer>(places, origin), on_grid<Integer>(directions, direction),
            on_grid<Integer>(places, a), on_grid<Integer>(places, b), on_grid<Integer>(places, c)};
  }
  [[nodiscard]] bool fits_lattice() const {
    return places.bits <= lattice_bits && directions.bits <= lattice_bits;
  }
  /// A t of 1 on the grids is 2 to the power of this.
  [[nodiscard]] int t_exponent() const { return places.exponent - directions.exponent; }

 private:
  template <class T>
  static Vec3<Binary> binary(const Vec3<T>& v) {
    return {Binary(v.x), Binary(v.y), Binary(v.z)};
  }
};

/// The sign of n/d − t_max, n/d being a t on the grids.
template <class Integer>
int beyond(const Problem& problem, const Integer& n, const Integer& d) {
  if (!problem.t_max) return -1;
  mpz_class t = to_mpz(n), limit = to_mpz(d) * mpz_class(static_cast<long>(problem.t_max->mantissa));
  const int shift = problem.t_exponent() - problem.t_max->exponent;
  if (problem.t_max->mantissa != 0) {
    if (shift > 0) {
      t <<= static_cast<unsigned long>(shift);
    } else {
      limit <<= static_cast<unsigned long>(-shift);
    }
  }
  return sign(mpz_class(t - limit)) * sign(d);
}

template <class Integer>
ExactVerdict verdict_of(const Problem& problem, const Meeting<Integer>& m) {
  const auto beyond_limit = [&](const Integer& n, const Integer& d) { return beyond(problem, n, d); };
  const int side = sign(m.determinant);
  if (side == 0) {
    if (sign(m.volume) != 0 || is_zero(m.normal) || is_zero(m.direction)) return ExactVerdict::miss;
    return InPlane(m, beyond_limit).touches() ? ExactVerdict::boundary : ExactVerdict::miss;
  }
  const int least = side * (side > 0 ? std::min({sign(m.of_a), sign(m.of_b), sign(m.of_c), sign(m.volume)})
                                     : std::max({sign(m.of_a), sign(m.of_b), sign(m.of_c), sign(m.volume)}));
  if (least < 0) return ExactVerdict::miss;
  const int end = beyond_limit(m.volume, m.determinant);
  if (end > 0) return ExactVerdict::miss;
  return least == 0 || end == 0 ? ExactVerdict::boundary : ExactVerdict::hit;
}

template <class Integer>
ExactHit hit_of(const Problem& problem) {
  const Meeting<Integer> m = problem.meeting<Integer>();
  ExactHit hit;
  hit.verdict = verdict_of(problem, m);
  if (sign(m.determinant) == 0) return hit;
  hit.t = std::scalbn(ratio(m.volume, m.determinant), problem.t_exponent());
  hit.beta = ratio(m.of_b, m.determinant);
  hit.gamma = ratio(m.of_c, m.determinant);
  const Vec3<long double> steepness(ratio(m.normal.x, m.determinant), ratio(m.normal.y, m.determinant),
                                    ratio(m.normal.z, m.determinant));
  hit.rise = std::scalbn(1 / length(steepness), problem.directions.exponent);
  return hit;
}

/// What bounds of the errors leave no doubt of: a hit, or a miss of a plane that is met.
template <class T>
std::optional<ExactVerdict> filtered(const Ray<T>& ray, const Triangle<T>& triangle, T t_max) {
  using Point = Vec3<Bounded>;
  const auto point = [](const Vec3<T>& v) { return Point(Bounded(v.x), Bounded(v.y), Bounded(v.z)); };
  const Meeting<Bounded> m(point(ray.origin), point(ray.direction), point(triangle.a), point(triangle.b),
                           point(triangle.c));
  if (!m.determinant.is_certain()) return std::nullopt;
  bool is_certain = true;
  const auto excludes = [&](const Bounded& value) {
    is_certain = is_certain && value.is_certain();
    return value.is_certain() && value.sign() != m.determinant.sign();
  };
  if (excludes(m.of_a) || excludes(m.of_b) || excludes(m.of_c) || excludes(m.volume))
    return ExactVerdict::miss;
  if (!std::isinf(t_max) && excludes(m.determinant * Bounded(t_max) - m.volume)) return ExactVerdict::miss;
  return is_certain ? std::optional(ExactVerdict::hit) : std::nullopt;
}

template <class T>
bool is_usable(const Ray<T>& ray, const Triangle<T>& triangle, T t_max) {
  return is_finite(ray) && all_finite(triangle.a) && all_finite(triangle.b) && all_finite(triangle.c) &&
         !std::isnan(t_max) && t_max != -std::numeric_limits<T>::infinity();
}

}  // namespace

template <class T>
ExactHit exact_hit(const Ray<T>& ray, const Triangle<T>& triangle, T t_max) {
  if (!is_usable(ray, triangle, t_max)) {
    ExactHit hit;
    hit.non_finite = true;
    return hit;
  }
  const Problem problem(ray, triangle, t_max);
  return problem.fits_lattice() ? hit_of<Int128>(problem) : hit_of<BigInteger>(problem);
}

template <class T>
ExactVerdict exact_verdict(const Ray<T>& ray, const Triangle<T>& triangle, T t_max) {
  if (!is_usable(ray, triangle, t_max)) return ExactVerdict::miss;
  // Most floats fit the lattice, which is then faster than the filter, by 1.6 times here; most doubles do
  // not.
  constexpr bool tries_lattice_first = std::is_same_v<T, float>;
  const auto filter = [&] { return filtered(ray, triangle, t_max); };
  if constexpr (!tries_lattice_first) {
    if (const auto certain = filter()) return *certain;
  }
  const Problem problem(ray, triangle, t_max);
  if (problem.fits_lattice()) return verdict_of(problem, problem.meeting<Int128>());
  if constexpr (tries_lattice_first) {
    if (const auto certain = filter()) return *certain;
  }
  return verdict_of(problem, problem.meeting<BigInteger>());
}

template ExactHit exact_hit(const Ray<float>&, const Triangle<float>&, float);
template ExactHit exact_hit(const Ray<double>&, const Triangle<double>&, double);
template ExactVerdict exact_verdict(const Ray<float>&, const Triangle<float>&, float);
template ExactVerdict exact_verdict(const Ray<double>&, const Triangle<double>&, double);

}  // namespace raysweep
