// The oracle against cases whose answer is plain, and against fractions.
#include "experiments/intersection/oracle.h"

#include <gtest/gtest.h>

#include "results/statistics/random.h"
#include "tests/experiments/intersection/rational_oracle.h"

namespace raysweep {
namespace {

template <class T>
class Oracle : public testing::Test {
 protected:
  static constexpr T infinity = std::numeric_limits<T>::infinity();
  static constexpr T ulp = std::numeric_limits<T>::epsilon();
  static Triangle<T> plain() { return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}; }
  static Ray<T> down(T x, T y) { return {{x, y, 1}, {0, 0, -1}}; }

  /// Both ways to ask must agree.
  static ExactVerdict verdict(const Ray<T>& ray, const Triangle<T>& triangle, T t_max = infinity) {
    const ExactVerdict with_values = exact_hit(ray, triangle, t_max).verdict;
    EXPECT_EQ(exact_verdict(ray, triangle, t_max), with_values);
    return with_values;
  }

  static void expect_rational(const Ray<T>& ray, const Triangle<T>& triangle, T t_max) {
    const RationalHit exact = rational_hit(ray, triangle, t_max);
    const ExactHit hit = exact_hit(ray, triangle, t_max);
    ASSERT_EQ(exact_verdict(ray, triangle, t_max), exact.verdict);
    ASSERT_EQ(hit.verdict, exact.verdict);
    ASSERT_EQ(std::isnan(hit.t), !exact.meets_plane);
    if (!exact.meets_plane) return;
    ASSERT_TRUE(is_right_to_60_bits(hit.t, exact.t)) << static_cast<double>(hit.t);
    ASSERT_TRUE(is_right_to_60_bits(hit.beta, exact.beta)) << static_cast<double>(hit.beta);
    ASSERT_TRUE(is_right_to_60_bits(hit.gamma, exact.gamma)) << static_cast<double>(hit.gamma);
  }

  T any() {
    const auto steps = size_t{1} << std::numeric_limits<T>::digits;
    return static_cast<T>(random_.sign() * static_cast<double>(random_.index(steps)) /
                          static_cast<double>(steps));
  }
  Vec3<T> any_point() {
    const T x = any(), y = any();
    return {x, y, any()};
  }
  Triangle<T> any_triangle() {
    const Vec3<T> a = any_point(), b = any_point();
    return {a, b, any_point()};
  }

  Random random_{5};
};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(Oracle, Reals);

TYPED_TEST(Oracle, inside_is_a_hit_and_beside_or_behind_a_miss) {
  using T = TypeParam;
  EXPECT_EQ(this->verdict(this->down(T(0.25), T(0.25)), this->plain()), ExactVerdict::hit);
  EXPECT_EQ(this->verdict(this->down(T(0.75), T(0.75)), this->plain()), ExactVerdict::miss);
  EXPECT_EQ(this->verdict({{T(0.25), T(0.25), 1}, {0, 0, 1}}, this->plain()), ExactVerdict::miss);
  EXPECT_EQ(this->verdict({{T(0.25), T(0.25), -1}, {0, 0, 1}}, this->plain()), ExactVerdict::hit)
      << "from below";
}

TYPED_TEST(Oracle, edges_and_corners_are_boundary_and_an_ulp_beside_them_nothing_is) {
  using T = TypeParam;
  const T half(0.5), least = std::numeric_limits<T>::denorm_min();
  for (const auto& [x, y] : {std::pair<T, T>{0, half}, {half, 0}, {half, half}, {0, 0}, {1, 0}, {0, 1}})
    EXPECT_EQ(this->verdict(this->down(x, y), this->plain()), ExactVerdict::boundary) << x << ", " << y;
  EXPECT_EQ(this->verdict(this->down(half, half - this->ulp / 4), this->plain()), ExactVerdict::hit);
  EXPECT_EQ(this->verdict(this->down(half, half + this->ulp / 2), this->plain()), ExactVerdict::miss);
  EXPECT_EQ(this->verdict(this->down(half, least), this->plain()), ExactVerdict::hit);
  EXPECT_EQ(this->verdict(this->down(half, -least), this->plain()), ExactVerdict::miss);
}

TYPED_TEST(Oracle, both_ends_of_a_ray_are_boundary) {
  using T = TypeParam;
  const T quarter(0.25);
  const Ray<T> ray = this->down(quarter, quarter);
  EXPECT_EQ(this->verdict(ray, this->plain(), 1), ExactVerdict::boundary);
  EXPECT_EQ(this->verdict(ray, this->plain(), 1 + this->ulp), ExactVerdict::hit);
  EXPECT_EQ(this->verdict(ray, this->plain(), 1 - this->ulp / 2), ExactVerdict::miss);
  EXPECT_EQ(this->verdict(ray, this->plain(), 0), ExactVerdict::miss);
  EXPECT_EQ(this->verdict(ray, this->plain(), -1), ExactVerdict::miss);
  EXPECT_EQ(this->verdict({{quarter, quarter, 0}, {0, 0, -1}}, this->plain()), ExactVerdict::boundary);
  EXPECT_EQ(this->verdict({{quarter, quarter, 0}, {0, 0, -1}}, this->plain(), 0), ExactVerdict::boundary);
  EXPECT_EQ(this->verdict({{quarter, quarter, 0}, {0, 0, -1}}, this->plain(), -1), ExactVerdict::miss);
}

TYPED_TEST(Oracle, parallel_is_a_miss_and_in_the_plane_only_who_touches_is_boundary) {
  using T = TypeParam;
  const auto along = [&](T ox, T oy, T dx, T dy, T t_max) {
    return this->verdict({{ox, oy, 0}, {dx, dy, 0}}, this->plain(), t_max);
  };
  EXPECT_EQ(this->verdict({{-1, T(0.25), 1}, {1, 0, 0}}, this->plain()), ExactVerdict::miss) << "parallel";
  const T forever = this->infinity;
  EXPECT_EQ(along(-1, T(0.25), 1, 0, forever), ExactVerdict::boundary) << "across";
  EXPECT_EQ(along(-1, T(0.25), 1, 0, 1), ExactVerdict::boundary) << "up to an edge";
  EXPECT_EQ(along(-1, T(0.25), 1, 0, T(0.5)), ExactVerdict::miss) << "ends before it";
  EXPECT_EQ(along(-1, T(0.25), -1, 0, forever), ExactVerdict::miss) << "leads away";
  EXPECT_EQ(along(-1, T(1.5), 1, 0, forever), ExactVerdict::miss) << "beside";
  EXPECT_EQ(along(-1, 1, 1, 0, forever), ExactVerdict::boundary) << "touches a corner";
  EXPECT_EQ(along(-1, 0, 1, 0, forever), ExactVerdict::boundary) << "follows an edge";
  EXPECT_EQ(along(2, 0, 1, 0, forever), ExactVerdict::miss) << "follows an edge's line, beyond it";
  EXPECT_EQ(along(T(0.25), T(0.25), 1, 1, T(0.01)), ExactVerdict::boundary) << "all of it inside";
  EXPECT_EQ(along(T(0.25), 0, 1, 0, T(0.01)), ExactVerdict::boundary) << "all of it on an edge";
}

TYPED_TEST(Oracle, no_area_and_no_direction_are_misses) {
  using T = TypeParam;
  const Ray<T> ray = this->down(0, 0);
  EXPECT_EQ(this->verdict(ray, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}), ExactVerdict::miss);
  EXPECT_EQ(this->verdict(ray, {{-1, 0, 0}, {1, 0, 0}, {1, 0, 0}}), ExactVerdict::miss);
  EXPECT_EQ(this->verdict(ray, {{-1, -1, 0}, {1, 1, 0}, {3, 3, 0}}), ExactVerdict::miss);
  EXPECT_EQ(this->verdict({{T(0.25), T(0.25), 0}, {0, 0, 0}}, this->plain()), ExactVerdict::miss);
}

TYPED_TEST(Oracle, what_is_not_finite_is_a_flagged_miss) {
  using T = TypeParam;
  const T nan = std::numeric_limits<T>::quiet_NaN();
  for (const T bad : {nan, this->infinity, -this->infinity}) {
    EXPECT_TRUE(exact_hit<T>({{0, bad, 1}, {0, 0, -1}}, this->plain()).non_finite);
    EXPECT_TRUE(exact_hit<T>({{0, 0, 1}, {bad, 0, -1}}, this->plain()).non_finite);
    EXPECT_TRUE(exact_hit<T>(this->down(0, 0), {{0, 0, 0}, {1, bad, 0}, {0, 1, 0}}).non_finite);
    EXPECT_EQ(this->verdict(this->down(0, 0), {{0, 0, 0}, {1, bad, 0}, {0, 1, 0}}), ExactVerdict::miss);
  }
  EXPECT_TRUE(exact_hit<T>(this->down(0, 0), this->plain(), nan).non_finite);
  EXPECT_FALSE(exact_hit<T>(this->down(0, 0), this->plain()).non_finite);
}

TYPED_TEST(Oracle, values_tell_where_and_how_steeply_the_plane_is_met) {
  using T = TypeParam;
  const ExactHit hit = exact_hit<T>({{T(0.25), T(-2.5), 3}, {0, 3, -3}}, this->plain());
  EXPECT_EQ(hit.verdict, ExactVerdict::hit);
  EXPECT_EQ(hit.t, 1.0L);
  EXPECT_EQ(hit.beta, 0.25L);
  EXPECT_EQ(hit.gamma, 0.5L);
  EXPECT_EQ(hit.rise, 3.0L);
  const ExactHit beside = exact_hit<T>(this->down(2, 4), this->plain());
  EXPECT_EQ(beside.verdict, ExactVerdict::miss);
  EXPECT_EQ(beside.gamma, 4.0L);
}

TYPED_TEST(Oracle, is_what_fractions_say_of_random_rays) {
  using T = TypeParam;
  for (int i = 0; i < 20'000; ++i) {
    const Ray<T> ray{this->any_point(), this->any_point()};
    ASSERT_NO_FATAL_FAILURE(this->expect_rational(ray, this->any_triangle(), this->infinity));
  }
}

TYPED_TEST(Oracle, is_what_fractions_say_of_rays_to_edges_moved_by_ulps_and_ended_where_they_hit) {
  using T = TypeParam;
  int found[3] = {};
  for (int i = 0; i < 20'000; ++i) {
    const Triangle<T> triangle = this->any_triangle();
    const T share = std::abs(this->any());
    Vec3<T> target = triangle.a + (triangle.b - triangle.a) * share;
    if (i % 4 == 0) target = triangle.c;
    if (i % 3 == 0) target.x = std::nextafter(target.x, this->infinity);
    const Vec3<T> origin = this->any_point();
    const Ray<T> ray{origin, target - origin};
    const T t_max = i % 2 == 0 ? this->infinity : std::nextafter(T(1), T(this->random_.index(3)));
    ASSERT_NO_FATAL_FAILURE(this->expect_rational(ray, triangle, t_max));
    ++found[static_cast<int>(exact_verdict(ray, triangle, t_max))];
  }
  EXPECT_GT(found[static_cast<int>(ExactVerdict::miss)], 1000);
  EXPECT_GT(found[static_cast<int>(ExactVerdict::hit)], 1000);
}

TYPED_TEST(Oracle, is_what_fractions_say_on_a_coarse_lattice_where_boundaries_are_frequent) {
  using T = TypeParam;
  const auto point = [&] {
    const auto n = [&] { return static_cast<T>(this->random_.index(7)) - 3; };
    const T x = n(), y = n();
    return Vec3<T>(x, y, n());
  };
  int boundaries = 0;
  for (int i = 0; i < 50'000; ++i) {
    const Vec3<T> a = point(), b = point(), c = point(), origin = point(), direction = point();
    const T t_max = i % 2 == 0 ? this->infinity : T(this->random_.index(3));
    const ExactVerdict verdict = this->verdict({origin, direction}, {a, b, c}, t_max);
    if (rational_hit<T>({origin, direction}, {a, b, c}, t_max).meets_plane) {
      ASSERT_NO_FATAL_FAILURE(this->expect_rational({origin, direction}, {a, b, c}, t_max));
    }
    boundaries += verdict == ExactVerdict::boundary;
  }
  EXPECT_GT(boundaries, 1000);
}

TYPED_TEST(Oracle, is_what_fractions_say_of_the_largest_numbers_that_fit_the_lattice_and_of_larger_ones) {
  using T = TypeParam;
  const T digits = std::ldexp(T(1), 24) - 1;
  for (int i = 0; i < 40'000; ++i) {
    const int bits = 36 + i % 11;
    const auto point = [&] {
      const auto n = [&] {
        return this->random_.index(8) == 0
                   ? T(1)
                   : static_cast<T>(this->random_.sign()) * std::ldexp(digits, bits - 24);
      };
      const T x = n(), y = n();
      return Vec3<T>(x, y, n());
    };
    const Vec3<T> a = point(), b = point(), c = point(), origin = point(), direction = point();
    if (!rational_hit<T>({origin, direction}, {a, b, c}, this->infinity).meets_plane) continue;
    ASSERT_NO_FATAL_FAILURE(this->expect_rational({origin, direction}, {a, b, c}, this->infinity)) << bits;
  }
}

TYPED_TEST(Oracle, is_what_fractions_say_when_exponents_differ_widely) {
  using T = TypeParam;
  const int exponents = std::numeric_limits<T>::max_exponent - std::numeric_limits<T>::min_exponent;
  const auto scaled = [&](T value) {
    return std::ldexp(value,
                      static_cast<int>(this->random_.index(static_cast<size_t>(exponents))) - exponents / 2);
  };
  const auto point = [&] {
    const T x = scaled(this->any()), y = scaled(this->any());
    return Vec3<T>(x, y, scaled(this->any()));
  };
  for (int i = 0; i < 5'000; ++i) {
    const Vec3<T> a = point(), b = point(), c = point(), origin = point(), direction = point();
    const T t_max = scaled(std::abs(this->any()));
    const RationalHit exact = rational_hit<T>({origin, direction}, {a, b, c}, t_max);
    ASSERT_EQ(exact_verdict<T>({origin, direction}, {a, b, c}, t_max), exact.verdict);
    ASSERT_EQ((exact_hit<T>({origin, direction}, {a, b, c}, t_max).verdict), exact.verdict);
  }
}

/// The filter answers where it is sure: if it erred, the other path would say so.
TYPED_TEST(Oracle, is_of_one_mind_with_itself_on_a_hundred_thousand_pairs) {
  using T = TypeParam;
  for (int i = 0; i < 100'000; ++i) {
    const Triangle<T> triangle = this->any_triangle();
    const T share = std::abs(this->any());
    const Vec3<T> origin = this->any_point(), edge = triangle.a + (triangle.b - triangle.a) * share;
    const Vec3<T> inside = edge + (triangle.c - edge) * (i % 2 == 0 ? T(0) : std::abs(this->any()));
    this->verdict({origin, normalize(inside - origin)}, triangle);
    if (testing::Test::HasFailure()) FAIL() << "pair " << i;
  }
}

}  // namespace
}  // namespace raysweep
