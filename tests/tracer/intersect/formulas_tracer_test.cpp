// The tracer's own methods and their formulas are one thing.
#include <gtest/gtest.h>

#include <bit>

#include "tests/tracer/intersect/lattice.h"
#include "tracer/intersect/all.h"
#include "tracer/intersect/study.h"

namespace raysweep {
namespace {

template <class T>
class Formulas : public testing::Test {
 public:
  static constexpr T far = std::numeric_limits<T>::infinity();

  template <class Method>
  static auto by_formula(const Ray<T>& ray, const Triangle<T>& triangle) {
    constexpr Variant base = base_variant<Method>();
    if constexpr (has_constants<Method>) {
      return solve<Method, base>(ray, Method::prepare(triangle), far);
    } else {
      return solve<Method, base>(ray, triangle, far);
    }
  }
  template <class Method>
  static auto by_tracer(const Ray<T>& ray, const Triangle<T>& triangle) {
    return Method::intersect(ray, Method::prepare(triangle));
  }
};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(Formulas, Reals);

template <class T>
bool are_same_bits(T a, T b) {
  using Bits = std::conditional_t<sizeof(T) == 4, uint32_t, uint64_t>;
  return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

template <class T>
bool are_same_bits(const std::optional<TriangleHit<T>>& a, const std::optional<TriangleHit<T>>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return are_same_bits(a->t, b->t) && are_same_bits(a->beta, b->beta) && are_same_bits(a->gamma, b->gamma);
}

template <class T>
struct AnyPair {
  Ray<T> ray;
  Triangle<T> triangle;
  bool is_in_plane;  // or parallel to it, or there is none
};

/// Large pairs, small ones with their edges and corners, and those divided by three, so that edges round.
template <class T>
AnyPair<T> any_pair(LatticeRandom& random) {
  const int64_t unit = std::array{1, 3, 1 << 20}[random.below(3)];
  const LatticePair pair = unit == 1 << 20 ? random.large_pair(unit) : random.small_pair();
  return {pair.ray<T>(unit), pair.triangle<T>(unit), Cramer(pair).det == 0};
}

TYPED_TEST(Formulas, the_tracers_cramer_methods_answer_as_their_formulas_bit_for_bit) {
  LatticeRandom random(5);
  int hits = 0;
  for (int i = 0; i < 300'000; ++i) {
    const AnyPair<TypeParam> pair = any_pair<TypeParam>(random);
    const auto& ray = pair.ray;
    const auto& triangle = pair.triangle;
    const auto moller = this->template by_tracer<MollerTrumbore>(ray, triangle);
    const auto morozov = this->template by_tracer<Morozov>(ray, triangle);
    ASSERT_TRUE(are_same_bits(this->template by_formula<MollerTrumbore>(ray, triangle), moller)) << i;
    ASSERT_TRUE(are_same_bits(this->template by_formula<Morozov>(ray, triangle), morozov)) << i;
    hits += moller.has_value();
  }
  EXPECT_GT(hits, 30'000);
}

// Its tracer's form decides what rounding leaves open, and keeps weights below 1; its formula does not.
TYPED_TEST(Formulas, woops_formula_finds_what_the_tracers_form_finds_away_from_edges_and_from_the_plane) {
  LatticeRandom random(6);
  int hits = 0;
  for (int i = 0; i < 300'000; ++i) {
    const auto [ray, triangle, is_in_plane] = any_pair<TypeParam>(random);
    const auto robust = this->template by_tracer<WoopWatertight>(ray, triangle);
    const auto plain = this->template by_formula<WoopWatertight>(ray, triangle);
    const auto& either = robust ? robust : plain;
    if (is_in_plane || !either || either->t < TypeParam(1e-4) ||
        std::min({either->beta, either->gamma, 1 - either->beta - either->gamma}) < TypeParam(1e-4))
      continue;
    ASSERT_TRUE(robust && plain) << i;
    ASSERT_TRUE(are_same_bits(robust->beta, plain->beta)) << i;
    ASSERT_TRUE(are_same_bits(robust->gamma, plain->gamma)) << i;
    ASSERT_NEAR(robust->t, plain->t, 64 * std::numeric_limits<TypeParam>::epsilon() * (1 + robust->t)) << i;
    hits++;
  }
  EXPECT_GT(hits, 10'000);
}

/// Both edges and the normal have the other sign, which no rounding sees; a weight of 0 may be −0.
TYPED_TEST(Formulas, of_morozov_and_of_kensler_and_shirley_are_one) {
  LatticeRandom random(6);
  int hits = 0;
  for (int i = 0; i < 100'000; ++i) {
    const AnyPair<TypeParam> pair = any_pair<TypeParam>(random);
    const auto morozov = this->template by_formula<Morozov>(pair.ray, pair.triangle);
    const auto kensler = this->template by_formula<KenslerShirley>(pair.ray, pair.triangle);
    ASSERT_EQ(morozov.has_value(), kensler.has_value());
    if (!morozov) continue;
    hits++;
    ASSERT_EQ(morozov->t, kensler->t);
    ASSERT_EQ(morozov->beta, kensler->beta);
    ASSERT_EQ(morozov->gamma, kensler->gamma);
  }
  EXPECT_GT(hits, 5'000);
}

}  // namespace
}  // namespace raysweep
