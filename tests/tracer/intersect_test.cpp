// What every method promises, over the one list of methods.
#include <gtest/gtest.h>

#include <random>

#include "tracer/accel/primitives.h"
#include "tracer/intersect/all.h"

namespace raysweep {
namespace {

template <class M, class T>
struct Variant {
  using Method = M;
  using Real = T;
};

template <class V>
class Method : public testing::Test {
 public:
  using M = typename V::Method;
  using T = typename V::Real;
  static_assert(Intersector<M, T>);

  static auto hit(const Ray<T>& ray, const Triangle<T>& triangle) {
    return M::intersect(ray, M::prepare(triangle));
  }
};
using Variants =
    testing::Types<Variant<MollerTrumbore, float>, Variant<MollerTrumbore, double>, Variant<Morozov, float>,
                   Variant<Morozov, double>, Variant<WoopWatertight, float>, Variant<WoopWatertight, double>>;
static_assert(std::tuple_size_v<Methods> == 3, "a new method must be added to Variants above");
TYPED_TEST_SUITE(Method, Variants);

template <class T>
Triangle<T> plain() {
  return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
}

TYPED_TEST(Method, gives_distance_and_weights) {
  using T = typename TestFixture::T;
  const auto hit = this->hit({{T(0.25), T(0.5), 3}, {0, 0, -1}}, plain<T>());
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->t, T(3));
  EXPECT_EQ(hit->beta, T(0.25));
  EXPECT_EQ(hit->gamma, T(0.5));
}

TYPED_TEST(Method, edges_and_corners_belong_to_the_triangle) {
  using T = typename TestFixture::T;
  for (const auto& [x, y] :
       {std::pair{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {0.5, 0.5}, {0.5, 0.0}, {0.0, 0.5}}) {
    EXPECT_TRUE(this->hit({{T(x), T(y), 1}, {0, 0, -1}}, plain<T>())) << x << ", " << y;
    EXPECT_TRUE(this->hit({{T(x), T(y), -1}, {0, 0, 1}}, plain<T>())) << x << ", " << y << " from behind";
  }
}

TYPED_TEST(Method, misses_beside_behind_and_in_the_plane) {
  using T = typename TestFixture::T;
  EXPECT_FALSE(this->hit({{T(0.6), T(0.6), 1}, {0, 0, -1}}, plain<T>()));
  EXPECT_FALSE(this->hit({{T(-0.1), T(0.5), 1}, {0, 0, -1}}, plain<T>()));
  EXPECT_FALSE(this->hit({{T(0.2), T(0.2), 1}, {0, 0, 1}}, plain<T>())) << "behind the origin";
  EXPECT_FALSE(this->hit({{-1, T(0.2), 0}, {1, 0, 0}}, plain<T>())) << "in the plane";
  EXPECT_FALSE(this->hit({{-1, T(0.2), 1}, {1, 0, 0}}, plain<T>())) << "parallel to the plane";
}

TYPED_TEST(Method, nan_and_degenerate_triangles_are_misses) {
  using T = typename TestFixture::T;
  const T nan = std::numeric_limits<T>::quiet_NaN();
  EXPECT_FALSE(this->hit({{nan, T(0.2), 1}, {0, 0, -1}}, plain<T>()));
  EXPECT_FALSE(this->hit({{T(0.2), T(0.2), 1}, {0, nan, -1}}, plain<T>()));
  EXPECT_FALSE(this->hit({{T(0.2), T(0.2), 1}, {0, 0, -1}}, {{0, 0, 0}, {1, nan, 0}, {0, 1, 0}}));
  EXPECT_FALSE(this->hit({{0, 0, 1}, {0, 0, -1}}, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}));
  EXPECT_FALSE(this->hit({{T(0.5), 0, 1}, {0, 0, -1}}, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}));
}

TYPED_TEST(Method, random_hits_are_where_the_weights_say) {
  using T = typename TestFixture::T;
  std::mt19937 random(3);
  std::uniform_real_distribution<T> uniform(-1, 1);
  const auto point = [&] { return Vec3<T>(uniform(random), uniform(random), uniform(random)); };
  int hits = 0;
  for (int i = 0; i < 200000; ++i) {
    const Triangle<T> tri{point(), point(), point()};
    // Aimed at a point of the triangle; grazing rays are the stability study's.
    const T u = (uniform(random) + 1) / 2, v = (uniform(random) + 1) / 2 * (1 - u);
    const Vec3<T> target = tri.a * (1 - u - v) + tri.b * u + tri.c * v;
    const Vec3<T> origin = point() * T(3);
    const Ray<T> ray{origin, normalize(target - origin)};
    const Vec3<T> normal = cross(tri.b - tri.a, tri.c - tri.a);
    if (length(normal) < T(0.05) || std::abs(dot(normalize(normal), ray.direction)) < T(0.1)) continue;
    if (std::min({u, v, 1 - u - v}) < T(0.001)) continue;  // rounding may take the target over the edge
    const auto hit = this->hit(ray, tri);
    ASSERT_TRUE(hit);
    hits++;
    const T tolerance = 2000 * std::numeric_limits<T>::epsilon();
    ASSERT_NEAR(hit->t, length(target - origin), tolerance);
    ASSERT_NEAR(hit->beta, u, tolerance * 10);
    ASSERT_NEAR(hit->gamma, v, tolerance * 10);
  }
  EXPECT_GT(hits, 50000);
}

template <class T>
class Solids : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(Solids, Reals);

TYPED_TEST(Solids, a_sphere_is_hit_at_its_nearer_root_from_outside_and_at_its_farther_from_inside) {
  using T = TypeParam;
  const Vec3<T> centre(1, 2, 3);
  EXPECT_NEAR((intersect_sphere<T>({{1, 2, -7}, {0, 0, 1}}, centre, 2)->enter), T(8), T(1e-5));
  EXPECT_NEAR((intersect_sphere<T>({{1, 2, -7}, {0, 0, 1}}, centre, 2)->leave), T(12), T(1e-5));
  EXPECT_NEAR((intersect_sphere<T>({{1, 2, 3}, {0, 0, 1}}, centre, 2)->leave), T(2), T(1e-5));
  EXPECT_LT((intersect_sphere<T>({{1, 2, 3}, {0, 0, 1}}, centre, 2)->enter), 0);
  EXPECT_LT((intersect_sphere<T>({{1, 2, 7}, {0, 0, 1}}, centre, 2)->leave), 0) << "behind";
  EXPECT_FALSE(intersect_sphere<T>({{1, 5, -7}, {0, 0, 1}}, centre, 2)) << "beside";
}

TYPED_TEST(Solids, a_small_far_sphere_keeps_its_digits) {
  using T = TypeParam;
  // The textbook discriminant b² − 4ac loses r² = 1e-4 against |f|² = 1e8 in float.
  const auto t = intersect_sphere<T>({{0, 0, 0}, {0, 0, 1}}, {T(0.005), 0, 10000}, T(0.01));
  ASSERT_TRUE(t);
  EXPECT_NEAR(t->enter, T(10000), T(0.02));
  EXPECT_FALSE(intersect_sphere<T>({{0, 0, 0}, {0, 0, 1}}, {T(0.02), 0, 10000}, T(0.01)));
}

TYPED_TEST(Solids, a_plane_is_hit_in_front_only_and_never_in_parallel) {
  using T = TypeParam;
  const Vec3<T> up(0, 1, 0);
  EXPECT_EQ(*intersect_plane<T>({{0, 3, 0}, {0, -1, 0}}, up, -1), T(2));
  EXPECT_FALSE(intersect_plane<T>({{0, 3, 0}, {0, 1, 0}}, up, -1));
  EXPECT_FALSE(intersect_plane<T>({{0, 3, 0}, {1, 0, 0}}, up, -1));
  EXPECT_FALSE(intersect_plane<T>({{0, 1, 0}, {1, 0, 0}}, up, -1)) << "inside the plane";
}

}  // namespace
}  // namespace raysweep
