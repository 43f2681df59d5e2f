// Formulas where numbers are none, or triangles have no area.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "tests/tracer/intersect/lattice.h"
#include "tracer/intersect/study.h"

namespace raysweep {
namespace {

template <class Real>
class FormulasSpecial : public testing::Test {
 public:
  using T = Real;
  static constexpr T far = std::numeric_limits<T>::infinity();

  /// Calls `visit(name, hit)` with what each variant of each method answers, but for those that fold their
  /// decision into t: what is no number is no miss for them.
  template <class Visit>
  static void for_each_answer(const Ray<T>& ray, const Triangle<T>& triangle, T t_max, Visit&& visit) {
    for_each_study_method([&]<class Method>(Method) {
      for_each_variant<Method, T>([&]<Variant variant> {
        if constexpr (variant.early_out != EarlyOut::folded)
          visit(Method::name, solve<Method, variant>(ray, data_for<Method, variant>(triangle), t_max));
      });
    });
  }
  static void expect_misses(const Ray<T>& ray, const Triangle<T>& triangle, T t_max = far) {
    for_each_answer(ray, triangle, t_max, [&](auto name, const auto& hit) { EXPECT_FALSE(hit) << name; });
  }
};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(FormulasSpecial, Reals);

/// Number `index` of the fifteen.
template <class T>
T& number(Ray<T>& ray, Triangle<T>& triangle, int index) {
  Vec3<T>* const vectors[] = {&ray.origin, &ray.direction, &triangle.a, &triangle.b, &triangle.c};
  Vec3<T>& vector = *vectors[index / 3];
  return index % 3 == 0 ? vector.x : index % 3 == 1 ? vector.y : vector.z;
}

TYPED_TEST(FormulasSpecial, nan_and_infinities_anywhere_are_misses) {
  using T = TypeParam;
  constexpr T inf = std::numeric_limits<T>::infinity();
  LatticeRandom random(7);
  for (int i = 0; i < 2000; ++i) {
    const LatticePair pair = i % 2 == 0 ? random.small_pair() : random.large_pair(1 << 20);
    for (const T special : {std::numeric_limits<T>::quiet_NaN(), inf, -inf}) {
      for (int index = 0; index < 15; ++index) {
        Ray<T> ray = pair.ray<T>(i % 2 == 0 ? 1 : 1 << 20);
        Triangle<T> triangle = pair.triangle<T>(i % 2 == 0 ? 1 : 1 << 20);
        number(ray, triangle, index) = special;
        SCOPED_TRACE(testing::Message() << "pair " << i << ", number " << index << " is " << special);
        this->expect_misses(ray, triangle);
        if (testing::Test::HasFailure()) return;
      }
    }
    this->expect_misses(pair.ray<T>(), pair.triangle<T>(), std::numeric_limits<T>::quiet_NaN());
  }
}

TYPED_TEST(FormulasSpecial, only_hits_nearer_than_the_limit_count) {
  using T = TypeParam;
  const Triangle<T> triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Ray<T> ray{{T(0.25), T(0.25), 2}, {0, 0, -1}};
  const auto hits = [&](T t_max) {
    int count = 0;
    this->for_each_answer(ray, triangle, t_max, [&](auto, const auto& hit) { count += hit.has_value(); });
    return count;
  };
  int answers = 0;
  this->for_each_answer(ray, triangle, this->far, [&](auto, const auto&) { answers++; });
  EXPECT_GT(answers, 100);
  EXPECT_EQ(hits(this->far), answers);
  EXPECT_EQ(hits(T(2.125)), answers);
  EXPECT_EQ(hits(T(1.875)), 0);
  EXPECT_EQ(hits(0), 0);
  EXPECT_EQ(hits(-1), 0);
}

/// The base variant of `Method` with another way to miss.
template <class Method>
constexpr Variant base_with(EarlyOut early_out) {
  Variant variant = base_variant<Method>();
  variant.early_out = early_out;
  return variant;
}

// The catalogue's N8: 0·∞ is no number, and so no miss.
TYPED_TEST(FormulasSpecial, a_decision_folded_into_t_is_a_false_hit_where_the_ray_is_parallel_to_the_plane) {
  using T = TypeParam;
  const Triangle<T> triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Ray<T> ray{{-1, T(0.25), 1}, {1, 0, 0}};
  constexpr Variant folded = base_with<Morozov>(EarlyOut::folded);
  const auto hit = solve<Morozov, folded>(ray, Morozov::prepare(triangle), this->far);
  ASSERT_TRUE(hit);
  EXPECT_TRUE(std::isnan(hit->t));
  constexpr Variant compared = base_with<Morozov>(EarlyOut::no);
  EXPECT_FALSE((solve<Morozov, compared>(ray, Morozov::prepare(triangle), this->far)));
}

TYPED_TEST(FormulasSpecial, a_decision_folded_into_t_is_the_same_elsewhere_and_t_as_coarse_as_t_and_1) {
  using T = TypeParam;
  constexpr T epsilon = std::numeric_limits<T>::epsilon();
  LatticeRandom random(12);
  int hits = 0, coarser = 0;
  for (int i = 0; i < 20'000; ++i) {
    const LatticePair pair = random.large_pair(1 << 20);
    if (Cramer(pair).det == 0) continue;
    const Ray<T> ray = pair.ray<T>(1 << 20);
    const auto prepared = Morozov::prepare(pair.triangle<T>(1 << 20));
    const auto some = solve<Morozov, base_with<Morozov>(EarlyOut::folded)>(ray, prepared, this->far);
    const auto other = solve<Morozov, base_with<Morozov>(EarlyOut::no)>(ray, prepared, this->far);
    ASSERT_EQ(some.has_value(), other.has_value()) << i;
    if (!some) continue;
    ASSERT_LE(std::abs(some->t - other->t), epsilon * (1 + other->t)) << i;
    hits++;
    coarser += some->t != other->t;
  }
  EXPECT_GT(hits, 1000);
  EXPECT_GT(coarser, hits / 10);
}

/// Of how many rays some variant of a method claims a hit.
using HitCounts = std::map<std::string_view, int>;
using Names = std::set<std::string_view>;

Names methods_that_hit(const HitCounts& hits) {
  Names names;
  for (const auto& [name, count] : hits)
    if (count > 0) names.insert(name);
  return names;
}

// What is asserted is what is, not what should be: a method that leaves one of these lists is better now.

// Whole numbers are exact, but not what these methods make of them: a normal scaled by 1/3, a ray sheared by
// 1/3 of its length.
TYPED_TEST(FormulasSpecial, in_whole_numbers_only_methods_that_scale_hit_planes_from_within_or_lines) {
  LatticeRandom random(8);
  HitCounts hits;
  int count = 0;
  for (int i = 0; i < 200'000; ++i) {
    const LatticePair pair = random.small_pair();
    if (Cramer(pair).det != 0) continue;
    this->for_each_answer(pair.ray<TypeParam>(), pair.triangle<TypeParam>(), this->far,
                          [&](auto name, const auto& hit) { hits[name] += hit.has_value(); });
    count++;
  }
  EXPECT_GT(count, 5'000);
  EXPECT_EQ(methods_that_hit(hits), (Names{"baldwin_weber", "shevtsov", "wald", "woop_watertight"}));
}

/// Rays at triangles that are a line without area: `corner` is where the one before it is.
template <class Fixture>
HitCounts hits_of_lines(int corner) {
  using T = typename Fixture::T;
  LatticeRandom random(9);
  constexpr int64_t unit = std::is_same_v<T, float> ? 1 << 22 : int64_t{1} << 50;
  HitCounts hits;
  for (int i = 0; i < 20'000; ++i) {
    const LatticePair pair = random.large_pair(unit);
    Triangle<T> triangle = pair.triangle<T>(unit);
    if (corner == 0) triangle.a = triangle.c;
    if (corner == 1) triangle.b = triangle.a;
    if (corner == 2) triangle.c = triangle.b;
    Ray<T> ray = pair.ray<T>(unit);
    const T along = static_cast<T>(random.below(1024)) / 1024;
    ray.direction =
        (triangle.a + (triangle.b - triangle.a) * along + (triangle.c - triangle.b) * along) - ray.origin;
    Fixture::for_each_answer(ray, triangle, Fixture::far,
                             [&](auto name, const auto& hit) { hits[name] += hit.has_value(); });
  }
  return hits;
}

// AB × AC is 0 to the last bit where two corners are one. D × AC, from which Möller and Trumbore start, is
// rounded before it meets AB: where B is C their determinant is noise, and so are the weights.
TYPED_TEST(FormulasSpecial, a_triangle_with_two_equal_corners_is_hit_by_moller_and_trumbore_alone) {
  EXPECT_EQ(methods_that_hit(hits_of_lines<FormulasSpecial<TypeParam>>(0)), Names{});
  EXPECT_EQ(methods_that_hit(hits_of_lines<FormulasSpecial<TypeParam>>(1)), Names{});
  EXPECT_EQ(methods_that_hit(hits_of_lines<FormulasSpecial<TypeParam>>(2)), Names{"moller_trumbore"});
}

}  // namespace
}  // namespace raysweep
