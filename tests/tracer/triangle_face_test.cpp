#include "tracer/accel/triangle_face.h"

#include <gtest/gtest.h>

#include <random>

namespace raysweep {
namespace {

constexpr size_t count = 16;

template <class T>
std::array<Triangle<T>, count> triangles_of(unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<T> along(-10, 10);
  const auto point = [&] {
    const T x = along(engine), y = along(engine), z = along(engine);
    return Vec3<T>(x, y, z);
  };
  std::array<Triangle<T>, count> all;
  for (Triangle<T>& t : all) {
    t.a = point();
    t.b = point();
    t.c = point();
  }
  all[3].c = all[3].a;                                // a line
  all[5].b = all[5].c = all[5].a;                     // a point
  all[7].c = (all[7].a + all[7].b) * T(0.5);          // a needle, or nothing
  all[9] = {{0, 0, 0}, {1, 0, 0}, {T(0.5), 2, 0}};    // two edges of equal length
  all[11].b.y = std::numeric_limits<T>::quiet_NaN();  // nothing
  return all;
}

template <class T>
class TriangleFaces : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(TriangleFaces, Reals);

TYPED_TEST(TriangleFaces, side_by_side_are_as_one_by_one) {
  using T = TypeParam;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    const auto triangles = triangles_of<T>(seed);
    const auto faces = faces_of(triangles);
    for (size_t i = 0; i < count; ++i) {
      const TriangleFace<T> alone = faces_of<T, 1>({triangles[i]})[0];
      EXPECT_EQ(faces[i].normal, alone.normal) << i;
      EXPECT_EQ(faces[i].clearance, alone.clearance) << i;
      EXPECT_EQ(faces[i].inset, alone.inset) << i;
    }
  }
}

TYPED_TEST(TriangleFaces, without_area_have_no_normal) {
  using T = TypeParam;
  const auto faces = faces_of(triangles_of<T>(1));
  for (const size_t i : {3, 5, 11}) {
    EXPECT_EQ(faces[i].normal, Vec3<T>()) << i;
    EXPECT_EQ(faces[i].clearance, 0) << i;
    EXPECT_EQ(faces[i].inset, 0) << i;
  }
}

/// Whichever edge is the longest.
TYPED_TEST(TriangleFaces, have_the_normal_of_any_two_edges) {
  using T = TypeParam;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    const auto triangles = triangles_of<T>(seed);
    const auto faces = faces_of(triangles);
    for (const size_t i : {0, 1, 2, 4, 6, 8, 9, 10}) {
      const Vec3d a(triangles[i].a), b(triangles[i].b), c(triangles[i].c);
      const Vec3d along = cross(b - a, c - a);
      // Rounded to T, and computed twice, each time off by as much more as the triangle is thin.
      const double thinness = length(b - a) * length(c - a) / length(along);
      const double bound = 2 * std::numeric_limits<T>::epsilon() + 16 * unit_roundoff<double> * thinness;
      EXPECT_LT(length(Vec3d(faces[i].normal) - normalize(along)), bound) << i;
      EXPECT_GT(faces[i].clearance, 0) << i;
      EXPECT_GT(faces[i].inset, 0) << i;
    }
  }
}

}  // namespace
}  // namespace raysweep
