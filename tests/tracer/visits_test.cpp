// A method that counts is told of every node that a ray visits, by hand-made hierarchies.
#include <gtest/gtest.h>

#include "tests/tracer/hit_rays.h"
#include "tests/tracer/triangle_row.h"
#include "tracer/wide/collapse_plan.h"
#include "tracer/wide/single_ray.h"

namespace raysweep {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
const Ray<float> down_the_row{{-0.5f, -0.5f, 3}, {0.001f, 0.002f, -1}};
const Ray<float> beside_the_row{{5, -0.5f, 3}, {0.001f, 0.002f, -1}};

struct Counted {
  long nodes, tests;
  friend bool operator==(const Counted&, const Counted&) = default;
};

template <class Trace>
Counted count(Trace&& trace) {
  CountingMethod::nodes = CountingMethod::tests = 0;
  trace();
  return {CountingMethod::nodes, CountingMethod::tests};
}

/// Every triangle is a leaf, so that a hierarchy of two has one node with children. What lies behind the
/// nearest hit is not tested.
TEST(visits, of_the_scalar_core_are_counted) {
  const ScalarCore<float, CountingMethod> two(triangles_in_a_row(2), "median", 1),
      four(triangles_in_a_row(4), "median", 1);
  EXPECT_EQ(count([&] { EXPECT_TRUE(two.closest(down_the_row)); }), (Counted{1, 1}));
  EXPECT_EQ(count([&] { EXPECT_FALSE(two.closest(beside_the_row)); }), (Counted{0, 0}));
  EXPECT_EQ(count([&] { EXPECT_TRUE(four.closest(down_the_row)); }), (Counted{2, 1}));
}

TEST(visits, of_one_ray_in_a_wide_tree_are_counted) {
  const Scene scene = triangles_in_a_row(4);
  const Primitives<float, CountingMethod> shapes(scene);
  const auto binary = build_by_name<float>("median", shapes.boxes(), shapes.sphere_count(), 1);
  const WideGeometry<CountingMethod, 4> geometry(shapes, collapse<4>(binary, shapes.boxes(), {0, false}));
  const auto trace = [&](const Ray<float>& ray) {
    return closest_hit(geometry, ray, Hit<float>::start(), infinity).has_value();
  };
  EXPECT_EQ(count([&] { EXPECT_TRUE(trace(down_the_row)); }), (Counted{1, 1}));
  EXPECT_EQ(count([&] { EXPECT_FALSE(trace(beside_the_row)); }), (Counted{1, 0}));
}

}  // namespace
}  // namespace raysweep
