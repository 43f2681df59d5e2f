// What variants there are, and what constants cost and are worth.
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "tests/tracer/intersect/exact.h"
#include "tests/tracer/intersect/near_values.h"

namespace raysweep {
namespace {

TEST(formulas_variants, each_differs_from_the_base_in_one_factor) {
  for_each_study_method([]<class Method>(Method) {
    constexpr auto star = variant_star<Method>();
    EXPECT_EQ(star[0], base_variant<Method>());
    for (size_t i = 1; i < star.size(); ++i) {
      const Variant &a = star[0], &b = star[i];
      const int changes = (a.division != b.division) + (a.reciprocal != b.reciprocal) + (a.order != b.order) +
                          (a.edges != b.edges) + (a.early_out != b.early_out) + (a.output != b.output) +
                          (a.data != b.data);
      EXPECT_EQ(changes, 1) << Method::name << ' ' << i;
    }
  });
}

TEST(formulas_variants, every_base_exists_but_that_of_angles_in_rationals) {
  for_each_study_method([]<class Method>(Method) {
    EXPECT_EQ((why_not<Method, float>(base_variant<Method>())), "") << Method::name;
    EXPECT_EQ((applies<Method, Exact>(base_variant<Method>())), Method::name != "angle_sum") << Method::name;
  });
}

TEST(formulas_variants, what_a_method_cannot_be_has_a_reason) {
  constexpr auto no_constants = "the method has no constants to compute ahead";
  constexpr auto no_weights = "the method finds no weights, only whether the point is inside";
  constexpr auto point_first = "the method looks for the point first, which is the distance";
  constexpr auto no_late_angles = "a sum of angles cannot be scaled: the point must be known";
  constexpr auto no_estimate = "the processor has no estimate of reciprocals of these numbers";
  constexpr auto no_wider = "there are no wider numbers to round constants from";
  EXPECT_EQ((why_not<WoopWatertight, float>({.data = Data::precomputed})), no_constants);
  EXPECT_EQ((why_not<WoopWatertight, float>({.data = Data::from_double})), no_constants);
  EXPECT_EQ((why_not<Wald, double>({.data = Data::from_double})), no_wider);
  EXPECT_EQ((why_not<HalfSpaces, float>({.output = Output::weights})), no_weights);
  EXPECT_EQ((why_not<Badouel, float>({.order = Order::weights_first})), point_first);
  EXPECT_EQ((why_not<AngleSum, float>({.division = Division::late, .output = Output::t})), no_late_angles);
  EXPECT_EQ((why_not<Wald, double>({.reciprocal = Reciprocal::newton})), no_estimate);
}

TEST(formulas_variants, constants_take_so_many_bytes_in_float) {
  std::map<std::string_view, size_t> bytes;
  for_each_study_method(
      [&]<class Method>(Method) { bytes[Method::name] = sizeof(typename Method::template Prepared<float>); });
  const std::map<std::string_view, size_t> expected{{"moller_trumbore", 36}, {"kensler_shirley", 48},
                                                    {"morozov", 48},         {"shevtsov", 40},
                                                    {"badouel", 44},         {"wald", 40},
                                                    {"keidy", 64},           {"perpendicular_planes", 48},
                                                    {"plucker", 88},         {"half_spaces", 64},
                                                    {"signed_areas", 52},    {"angle_sum", 52},
                                                    {"woop_watertight", 36}, {"baldwin_weber", 40},
                                                    {"havel_herout", 48}};
  EXPECT_EQ(bytes, expected);
}

/// The sum of errors of t and of weights, of `Method` in float with its constants computed in `Wide`.
template <class Method, class Wide>
long double sum_of_errors() {
  constexpr Variant base = base_variant<Method>();
  LatticeRandom random(10);
  long double sum = 0;
  for (int i = 0; i < 20'000; ++i) {
    const LatticePair pair = random.large_pair(unit<float>);
    const auto expected = near_case(pair, 0.001L);
    if (!expected) continue;
    const auto prepared = prepare_in<Method, Wide>(pair.triangle<float>(unit<float>));
    const auto hit =
        solve<Method, base>(pair.ray<float>(unit<float>), prepared, std::numeric_limits<float>::infinity());
    if (!hit) continue;
    sum += std::abs(hit->t - expected->t);
    if (base.output == Output::weights)
      sum += std::abs(hit->beta - expected->beta) + std::abs(hit->gamma - expected->gamma);
  }
  return sum;
}

// The edges of these coordinates are exact in float: Möller's and Trumbore's constants are the same in both.
TEST(formulas_variants, constants_computed_in_double_bring_values_nearer) {
  for_each_study_method([]<class Method>(Method) {
    if constexpr (has_constants<Method> && !std::same_as<Method, MollerTrumbore>) {
      const auto in_double = sum_of_errors<Method, double>(), in_float = sum_of_errors<Method, float>();
      testing::Test::RecordProperty(std::string(Method::name),
                                    std::to_string(static_cast<double>(in_double / in_float)));
      EXPECT_LT(in_double, in_float) << Method::name;
    }
  });
  EXPECT_EQ((sum_of_errors<MollerTrumbore, double>()), (sum_of_errors<MollerTrumbore, float>()));
}

template <class Method>
void expect_all_combinations(int expected_count) {
  constexpr long double epsilon = std::numeric_limits<float>::epsilon();
  LatticeRandom random(11);
  int hits = 0;
  for (int i = 0; i < 5'000; ++i) {
    const LatticePair pair = random.large_pair(unit<float>);
    const auto expected = near_case(pair, 2048 * epsilon);
    if (!expected) continue;
    hits += expected->is_hit;
    LargestErrors ignored;
    int count = 0;
    for_each_combination<Method, float>([&]<Variant variant> {
      NearVariant<Method, variant, float>(512 * epsilon)
          .add(pair.ray<float>(unit<float>), pair.triangle<float>(unit<float>), *expected, ignored);
      count++;
    });
    ASSERT_EQ(count, expected_count);
    ASSERT_FALSE(testing::Test::HasFatalFailure()) << i;
  }
  EXPECT_GT(hits, 500);
}

// The study's star changes one factor at a time; for the tracer's own methods all may change at once.
#if defined(__SSE__)
TEST(formulas_variants, moller_trumbore_is_right_in_every_combination) {
  expect_all_combinations<MollerTrumbore>(240);
}
TEST(formulas_variants, morozov_is_right_in_every_combination) { expect_all_combinations<Morozov>(240); }
TEST(formulas_variants, woop_is_right_in_every_combination) { expect_all_combinations<WoopWatertight>(120); }
#endif

}  // namespace
}  // namespace raysweep
