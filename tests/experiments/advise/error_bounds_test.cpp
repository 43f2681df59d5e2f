// Laws of error: what they promise holds for every hit of the catalogue, and they promise no less than they
// can.
#include "experiments/advise/error_bounds.h"

#include <gmpxx.h>

#include <limits>

#include "experiments/advise/rounded.h"
#include "experiments/intersection/draw.h"
#include "results/statistics/statistics.h"
#include "tests/experiments/advise/laws_hold.h"

namespace raysweep {
namespace {

template <class T>
class OfPrecision : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(OfPrecision, Precisions);

using Rational = mpq_class;

/// A number of T that is neither 0 nor infinite, of any exponent in a range that products stay in or leave.
template <class T>
T any_number(Random& random, int exponents) {
  const int exponent = static_cast<int>(random.index(static_cast<size_t>(2 * exponents))) - exponents;
  return static_cast<T>(random.sign() * std::ldexp(1 + uniform(random), exponent));
}

template <class T>
bool is_within_bound(const Rounded<T>& computed, const Rational& exact) {
  if (std::isinf(computed.error())) return true;
  const double high = static_cast<double>(computed.error());
  // A double above the bound, as fractions are made of doubles.
  const Rational bound(std::nextafter(high, std::numeric_limits<double>::infinity()));
  return abs(Rational(static_cast<double>(computed.value())) - exact) <= bound;
}

TYPED_TEST(OfPrecision, numbers_that_keep_book_are_never_farther_off_than_they_say) {
  using T = TypeParam;
  Random random(3);
  size_t known = 0;
  for (int i = 0; i < 20000; ++i) {
    const int exponents = i % 2 == 0 ? 4 : std::numeric_limits<T>::max_exponent / 2;
    const auto draw = [&] { return any_number<T>(random, exponents); };
    const T a = draw(), b = draw(), c = draw(), d = draw();
    const Rounded<T> sum = Rounded<T>(a) * b + Rounded<T>(c) * d, difference = Rounded<T>(a) - b;
    const Rational exact_sum = Rational(a) * Rational(b) + Rational(c) * Rational(d);
    const Rational exact_difference = Rational(a) - Rational(b);
    ASSERT_TRUE(is_within_bound(sum, exact_sum)) << a << ' ' << b << ' ' << c << ' ' << d;
    ASSERT_TRUE(is_within_bound(difference * sum, Rational(exact_difference * exact_sum)));
    if (exact_difference == 0) continue;
    const Rounded<T> quotient = sum / difference, rest = quotient - sum * difference;
    const Rational exact = exact_sum / exact_difference;
    ASSERT_TRUE(is_within_bound(quotient, exact)) << a << ' ' << b << ' ' << c << ' ' << d;
    ASSERT_TRUE(is_within_bound(rest, Rational(exact - exact_sum * exact_difference)));
    known += std::isfinite(rest.error());
  }
  EXPECT_GT(known, 10000u);
}

TYPED_TEST(OfPrecision, numbers_that_keep_book_compute_what_the_precision_does) {
  using T = TypeParam;
  Random random(4);
  for (int i = 0; i < 1000; ++i) {
    const T a = any_number<T>(random, 4), b = any_number<T>(random, 4), c = any_number<T>(random, 4);
    const Rounded<T> computed = (Rounded<T>(a) * b - c) / (Rounded<T>(b) + c);
    const T product = a * b;
    ASSERT_EQ(computed.value(), (product - c) / (b + c));
  }
}

TYPED_TEST(OfPrecision, no_hit_of_the_catalogue_errs_by_more_than_its_law_says) {
  EXPECT_GT(check_all_laws<TypeParam>(60).hits, 50000u);
}

/// Straight down on the middle of a right triangle of side `size` at (`offset`, `offset`, 0), from `height`.
template <class T>
HitBound bound_at(std::string_view method, double offset, double size, double height) {
  const T o = static_cast<T>(offset), s = static_cast<T>(size);
  const Triangle<T> triangle{{o, o, 0}, {o + s, o, 0}, {o, o + s, 0}};
  const T inside = o + s / 4;
  return error_law_of<T>(method).bound({{inside, inside, static_cast<T>(height)}, {0, 0, -1}}, triangle);
}

TYPED_TEST(OfPrecision, far_from_the_world_s_origin_only_what_is_computed_from_there_gets_worse) {
  using T = TypeParam;
  for (const char* relative : {"moller_trumbore", "kensler_shirley", "morozov", "woop_watertight"}) {
    EXPECT_LT(bound_at<T>(relative, 4096, 1, 8).point, 2 * bound_at<T>(relative, 0, 1, 8).point) << relative;
  }
  for (const char* from_there : {"badouel", "perpendicular_planes", "wald", "plucker", "baldwin_weber"}) {
    EXPECT_GT(bound_at<T>(from_there, 4096, 1, 8).point, 100 * bound_at<T>(from_there, 0, 1, 8).point)
        << from_there;
  }
}

TYPED_TEST(OfPrecision, where_products_leave_the_range_nothing_is_promised) {
  using T = TypeParam;
  const double huge = std::ldexp(1.0, std::numeric_limits<T>::max_exponent / 3);
  const double tiny = std::ldexp(1.0, std::numeric_limits<T>::min_exponent / 3);
  // Squares of the normal, the fourth power of the size.
  EXPECT_TRUE(std::isinf(bound_at<T>("perpendicular_planes", 0, huge, huge).point));
  EXPECT_TRUE(std::isinf(bound_at<T>("perpendicular_planes", 0, tiny, tiny).point));
  EXPECT_TRUE(std::isfinite(bound_at<T>("perpendicular_planes", 0, 1, 1).point));
}

TYPED_TEST(OfPrecision, of_a_ray_in_parallel_to_the_plane_nothing_is_promised) {
  using T = TypeParam;
  const Triangle<T> triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (const ErrorLaw<T>& law : error_laws<T>()) {
    const HitBound bound = law.bound({{-1, T(0.25), 1}, {1, 0, 0}}, triangle);
    EXPECT_TRUE(std::isinf(bound.t)) << law.method;
    EXPECT_TRUE(std::isinf(bound.point)) << law.method;
  }
}

TYPED_TEST(OfPrecision, bounds_of_the_tracer_s_methods_are_near_to_what_happens) {
  using T = TypeParam;
  const JudgedTrials<T> judged(case_of("F1"), 100, 5, 2000);
  for (const Subject<T>& subject : all_subjects<T>()) {
    const bool is_ours = subject.method == "moller_trumbore" || subject.method == "morozov" ||
                         subject.method == "woop_watertight";
    if (!is_ours || subject.change != "base") continue;
    const Hits<T> hits = subject.find_hits(judged.trials);
    std::vector<double> bounds, errors;
    for (size_t i = 0; i < hits.size(); ++i) {  // each ray has its own triangle
      const ExactHit& exact = judged.exact[i];
      if (!hits[i] || exact.verdict == ExactVerdict::miss) continue;
      const auto& [ray, triangle] = std::pair(judged.trials.rays[i].ray, judged.trials.triangles[i]);
      bounds.push_back(static_cast<double>(error_law_of<T>(subject.method).bound(ray, triangle).point));
      errors.push_back(
          static_cast<double>(point_error(ray, triangle, *hits[i], exact.t, exact.beta, exact.gamma)));
    }
    // Worst cases add up where rounding errors of either sign mostly cancel: of some thirty roundings on the
    // way about six times as much. Worse than 50 would be another formula's bound.
    EXPECT_LT(quantile(bounds, 0.999), 50 * quantile(errors, 0.999)) << subject.method;
  }
}

TEST(error_laws, there_is_one_for_every_method_of_the_study) {
  ASSERT_EQ(error_laws<float>().size(), study_method_names().size());
  for (size_t i = 0; i < study_method_names().size(); ++i) {
    EXPECT_EQ(error_laws<float>()[i].method, study_method_names()[i]);
    EXPECT_EQ(error_laws<double>()[i].method, study_method_names()[i]);
  }
  EXPECT_THROW((void)error_law_of<float>("no_such"), std::out_of_range);
}

}  // namespace
}  // namespace raysweep
