#include "tracer/math/box.h"

#include <gtest/gtest.h>

#include <random>

namespace raysweep {
namespace {

template <class T>
class Slab : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(Slab, Reals);

template <class T>
Box<T> unit_box() {
  Box<T> box;
  box.include(Vec3<T>(0, 0, 0));
  box.include(Vec3<T>(1, 1, 1));
  return box;
}

template <class T>
bool meets(const Vec3<T>& origin, const Vec3<T>& direction) {
  return !slab(unit_box<T>(), SlabRay<T>({origin, direction})).empty();
}

TYPED_TEST(Slab, a_ray_through_the_middle_enters_and_leaves_at_the_faces) {
  using T = TypeParam;
  const auto inside = slab(unit_box<T>(), SlabRay<T>({{T(0.5), T(0.5), -2}, {0, 0, 1}}));
  EXPECT_EQ(inside.enter, T(2));
  EXPECT_NEAR(inside.leave, T(3), T(1e-5));
}

TYPED_TEST(Slab, a_ray_inside_the_plane_of_a_face_meets_the_box) {
  using T = TypeParam;
  for (const T sign : {T(1), T(-1)}) {
    for (const T zero : {T(0), T(-0.0)}) {
      EXPECT_TRUE(meets<T>({0, T(0.5), sign * -2}, {zero, zero, sign})) << "lower face";
      EXPECT_TRUE(meets<T>({1, T(0.5), sign * 2}, {zero, zero, -sign})) << "upper face";
    }
  }
}

TYPED_TEST(Slab, parallel_rays_outside_miss_whatever_the_sign_of_zero) {
  using T = TypeParam;
  for (const T zero : {T(0), T(-0.0)}) {
    EXPECT_FALSE(meets<T>({T(1.5), T(0.5), -2}, {zero, zero, 1}));
    EXPECT_FALSE(meets<T>({T(-0.5), T(0.5), -2}, {zero, zero, 1}));
    EXPECT_TRUE(meets<T>({T(0.5), T(0.5), -2}, {zero, zero, 1}));
  }
}

TYPED_TEST(Slab, boxes_behind_are_missed_and_boxes_around_are_met) {
  using T = TypeParam;
  EXPECT_FALSE(meets<T>({T(0.5), T(0.5), 2}, {0, 0, 1}));
  EXPECT_TRUE(meets<T>({T(0.5), T(0.5), T(0.5)}, {0, 0, 1}));
}

TYPED_TEST(Slab, no_box_that_the_exact_ray_meets_is_lost) {
  using T = TypeParam;
  std::mt19937 random(11);
  std::uniform_real_distribution<T> uniform(-1, 1);
  int met = 0;
  for (int i = 0; i < 300000; ++i) {
    // Boxes as flat and as far away as triangles are, aimed at by a ray that really passes through a point of
    // them.
    Box<T> box;
    const Vec3<T> corner(uniform(random) * 100, uniform(random) * 100, uniform(random) * 100);
    box.include(corner);
    box.include(corner +
                Vec3<T>(std::abs(uniform(random)), i % 3 == 0 ? 0 : std::abs(uniform(random)), T(1e-3)));
    const Ray<T> ray{{uniform(random), uniform(random), uniform(random)}, normalize(box.centre())};
    using Exact = long double;
    Exact enter = 0, leave = std::numeric_limits<Exact>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      const Exact o = ray.origin[axis], d = ray.direction[axis];
      const Exact a = (box.lower()[axis] - o) / d, b = (box.upper()[axis] - o) / d;
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    if (enter > leave) continue;
    met++;
    ASSERT_FALSE(slab(box, SlabRay<T>(ray)).empty());
  }
  EXPECT_GT(met, 1000);
}

TYPED_TEST(Slab, a_larger_box_never_has_the_smaller_interval) {
  using T = TypeParam;
  std::mt19937 random(7);
  std::uniform_real_distribution<T> uniform(-3, 3);
  const auto point = [&] { return Vec3<T>(uniform(random), uniform(random), uniform(random)); };
  int met = 0;
  for (int i = 0; i < 200000; ++i) {
    Box<T> small;
    small.include(point());
    small.include(point());
    Box<T> large = small;
    large.include(point());
    Vec3<T> direction = point();
    if (i % 7 == 0) direction.x = 0;
    if (i % 11 == 0) direction.y = T(-0.0);
    Vec3<T> origin = point();
    if (i % 5 == 0) origin.x = small.lower().x;
    const SlabRay<T> ray({origin, direction});
    const Interval<T> inner = slab(small, ray), outer = slab(large, ray);
    if (inner.empty()) continue;
    met++;
    ASSERT_LE(outer.enter, inner.enter);
    ASSERT_GE(outer.leave, inner.leave);
  }
  EXPECT_GT(met, 10000);
}

}  // namespace
}  // namespace raysweep
