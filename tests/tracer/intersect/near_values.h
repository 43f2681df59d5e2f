// The claim that rounding is all that separates a formula from whole numbers, for any number of rays.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "tests/tracer/intersect/lattice.h"
#include "tests/tracer/intersect/which_variants.h"

namespace raysweep {

/// Coordinates are k/unit: every number of type `T` here is exact, as are the differences that make edges.
template <class T>
constexpr int64_t unit = std::is_same_v<T, float> ? 1 << 22 : 1 << 29;

/// What a method should find. The quotients are rounded once, to 64 bits.
struct NearCase {
  bool is_hit;
  long double t, beta, gamma;
};

/// Nothing if rounding may decide, or grows: at an edge, at t = 0, at a grazing angle, at a needle. `margin`
/// is that of weights and t.
inline std::optional<NearCase> near_case(const LatticePair& pair, long double margin) {
  const auto triangle = pair.triangle<double>();
  const Vec3d ab = triangle.b - triangle.a, ac = triangle.c - triangle.a, n = cross(ab, ac);
  const Vec3d direction = pair.ray<double>().direction;
  if (length(n) < 0.2 * length(ab) * length(ac) ||
      std::abs(dot(n, direction)) < 0.2 * length(n) * length(direction))
    return std::nullopt;
  const double box = max_abs(triangle.a) + max_abs(ab) + max_abs(pair.ray<double>().origin);
  if (std::min({length(ab), length(ac), length(direction)}) < 0.1 * box) return std::nullopt;
  const Cramer exact(pair);
  const auto ratio = [&](Int128 x) {
    return static_cast<long double>(x) / static_cast<long double>(exact.det);
  };
  const NearCase found{exact.is_hit(false, 0), ratio(exact.t), ratio(exact.beta), ratio(exact.gamma)};
  for (const long double value : {found.t, found.beta, found.gamma, 1 - found.beta - found.gamma})
    if (std::abs(value) < margin) return std::nullopt;
  return found;
}

/// Largest errors of t, relative to 1 + t, and of weights.
struct LargestErrors {
  long double t = 0, weights = 0;
};

template <class Method, Variant variant, class T>
class NearVariant {
 public:
  explicit NearVariant(long double tolerance) : tolerance_(tolerance) {}

  void add(const Ray<T>& ray, const Triangle<T>& triangle, const NearCase& expected,
           LargestErrors& errors) const {
    const auto hit = found(ray, triangle);
    ASSERT_EQ(hit.has_value(), expected.is_hit) << Method::name;
    if (!hit) return;
    if (variant.output != Output::hit) {
      errors.t = std::max(errors.t, std::abs(hit->t - expected.t) / (1 + expected.t));
      ASSERT_LE(std::abs(hit->t - expected.t), tolerance_ * (1 + expected.t)) << Method::name;
    }
    if (variant.output == Output::weights) {
      const long double error =
          std::max(std::abs(hit->beta - expected.beta), std::abs(hit->gamma - expected.gamma));
      errors.weights = std::max(errors.weights, error);
      ASSERT_LE(error, tolerance_) << Method::name;
    }
  }

 private:
  static auto found(const Ray<T>& ray, const Triangle<T>& triangle) {
    const T far = std::numeric_limits<T>::infinity();
    return solve<Method, variant>(ray, data_for<Method, variant>(triangle), far);
  }

  long double tolerance_;
};

/// The variants of every method on those of `pair_count` pairs that are neither near an edge nor ill-shaped:
/// decisions are right, and errors of t and of weights are those of a few hundred roundings.
template <WhichVariants which, class T>
void expect_near_values(uint64_t seed, int pair_count) {
  constexpr long double epsilon = std::numeric_limits<T>::epsilon();
  LatticeRandom random(seed);
  std::map<std::string, LargestErrors> errors;
  int hits = 0, misses = 0;
  for (int i = 0; i < pair_count; ++i) {
    const LatticePair pair = random.large_pair(unit<T>);
    const auto expected = near_case(pair, 2048 * epsilon);
    if (!expected) continue;
    (expected->is_hit ? hits : misses)++;
    SCOPED_TRACE(i);
    for_each_study_method([&]<class Method>(Method) {
      LargestErrors& largest = errors[std::string(Method::name)];
      for_each_variant_of<which, Method, T>([&]<Variant variant> {
        NearVariant<Method, variant, T>(512 * epsilon)
            .add(pair.ray<T>(unit<T>), pair.triangle<T>(unit<T>), *expected, largest);
      });
    });
    if (testing::Test::HasFatalFailure()) return;
  }
  EXPECT_GT(hits, pair_count / 20);
  EXPECT_GT(misses, pair_count / 20);
  const auto record = [&](const std::string& what, long double error) {
    testing::Test::RecordProperty(what + "_in_epsilons",
                                  std::to_string(static_cast<double>(error / epsilon)));
  };
  for (const auto& [method, largest] : errors) {
    record(method + "_t", largest.t);
    record(method + "_weights", largest.weights);
  }
}

}  // namespace raysweep
