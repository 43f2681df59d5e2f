// The claim that every formula is Cramer's rule, for any number of rays.
#pragma once

#include <gtest/gtest.h>

#include "tests/tracer/intersect/exact.h"
#include "tests/tracer/intersect/lattice.h"
#include "tests/tracer/intersect/which_variants.h"

namespace raysweep {

/// Whether `value` is numerator/det.
inline bool is_ratio(const Exact& value, Int128 numerator, Int128 det) {
  return value.value() * mpq_class(static_cast<long>(det)) == mpq_class(static_cast<long>(numerator));
}

template <class Method, Variant variant>
void expect_cramer(const LatticePair& pair, const Cramer& expected, int64_t t_max) {
  const auto data = data_for<Method, variant>(pair.triangle<Exact>());
  const auto hit = solve<Method, variant>(pair.ray<Exact>(), data, Exact(t_max));
  if (variant.early_out == EarlyOut::folded && expected.det == 0) {
    // What the variant is expected to fail: there is no t in which −1 could say that it is a miss.
    ASSERT_TRUE(hit) << Method::name;
    return;
  }
  ASSERT_EQ(hit.has_value(), expected.is_hit(variant.edges == Edges::strict, t_max)) << Method::name;
  if (!hit) return;
  if (variant.output != Output::hit) {
    ASSERT_TRUE(is_ratio(hit->t, expected.t, expected.det)) << Method::name;
  }
  if (variant.output == Output::weights) {
    ASSERT_TRUE(is_ratio(hit->beta, expected.beta, expected.det)) << Method::name;
    ASSERT_TRUE(is_ratio(hit->gamma, expected.gamma, expected.det)) << Method::name;
  }
}

/// The variants of every method that exist for rationals, on `pair_count` pairs of which many are special.
template <WhichVariants which>
void expect_cramers_rule(uint64_t seed, int pair_count) {
  LatticeRandom random(seed);
  int hits = 0, borders = 0, without_point = 0, behind = 0, at_origin = 0, at_limit = 0;
  for (int i = 0; i < pair_count; ++i) {
    const LatticePair pair = random.small_pair();
    const Cramer expected(pair);
    const int64_t t_max = std::array{1, 2, 3, 1000}[random.below(4)];
    SCOPED_TRACE(i);
    for_each_study_method([&]<class Method>(Method) {
      if constexpr (Formula<Method, Exact>)
        for_each_variant_of<which, Method, Exact>(
            [&]<Variant variant> { expect_cramer<Method, variant>(pair, expected, t_max); });
    });
    if (testing::Test::HasFatalFailure()) return;
    hits += expected.is_hit(true, t_max);
    borders += expected.is_on_border();
    without_point += expected.det == 0;
    behind += expected.t < 0;
    at_origin += expected.det != 0 && expected.t == 0;
    at_limit += expected.det != 0 && expected.t == t_max * expected.det;
  }
  const int least = std::min({hits, borders, without_point, behind, at_origin, at_limit});
  EXPECT_GT(least, pair_count / 100) << "some kind of pair is rare";
}

}  // namespace raysweep
