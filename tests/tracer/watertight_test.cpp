// Cases W1 and W2 of the failure catalogue: no ray passes at an edge or a corner, through all that decides on
// a hit. Of methods that promise nothing some must, else the rays would say nothing.
#include <gtest/gtest.h>

#include "tests/tracer/edge_rays.h"
#include "tracer/accel/scalar.h"
#include "tracer/intersect/all.h"

namespace raysweep {
namespace {

template <class T>
class Watertight : public testing::Test {
 protected:
  /// All of `rays` must hit.
  static void expect_no_leak(const Scene& scene, const std::vector<Ray<T>>& rays) {
    for_each_method([&](auto method) {
      const ScalarCore<T, decltype(method)> core(scene, "sah", 4);
      const auto leaks = std::ranges::count_if(rays, [&](const Ray<T>& ray) { return !core.closest(ray); });
      if (method.is_watertight) {
        EXPECT_EQ(leaks, 0) << method.name;
      } else {
        EXPECT_GT(leaks, 0) << method.name << " of " << rays.size();
      }
    });
  }

  std::array<uint32_t, 3> any_triangle(const Mesh& mesh) {
    return mesh.triangles[random_() % mesh.triangles.size()];
  }
  Vec3d any_point(double scale) {
    std::uniform_real_distribution<double> uniform(-scale, scale);
    const double x = uniform(random_), y = uniform(random_);
    return {x, y, uniform(random_)};
  }

  std::mt19937 random_{11};
};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(Watertight, Reals);

TYPED_TEST(Watertight, w1_no_ray_leaves_a_closed_mesh_at_an_edge_or_a_corner) {
  using T = TypeParam;
  const Mesh mesh = rough_sphere(16, 16, this->random_);
  std::vector<Ray<T>> rays;
  for (int i = 0; i < 100'000; ++i) {
    const Vec3d target = point_on_border(mesh, this->any_triangle(mesh), this->random_);
    rays.push_back(ray_towards<T>(this->any_point(0.5), target));
  }
  this->expect_no_leak(scene_of({mesh}), rays);
}

TYPED_TEST(Watertight, no_ray_leaves_a_closed_mesh_in_the_plane_of_a_triangle) {
  using T = TypeParam;
  const Mesh mesh = rough_sphere(16, 16, this->random_);
  std::vector<Ray<T>> rays;
  while (rays.size() < 50'000) {
    const auto triangle = this->any_triangle(mesh);
    const Vec3d a(mesh.vertices[triangle[0]]), b(mesh.vertices[triangle[1]]), c(mesh.vertices[triangle[2]]);
    const Vec3d normal = normalize(cross(b - a, c - a)), somewhere = this->any_point(1);
    const Vec3d origin = somewhere - normal * dot(somewhere - a, normal);
    if (length(origin) > 1.2) continue;  // may be outside
    rays.push_back(ray_towards<T>(origin, point_on_border(mesh, triangle, this->random_)));
  }
  this->expect_no_leak(scene_of({mesh}), rays);
}

TYPED_TEST(Watertight, no_ray_passes_through_a_sheet_seen_from_any_distance) {
  using T = TypeParam;
  for (const double rough : {0.0, 0.01}) {
    const Mesh mesh = sheet(16, rough, this->random_);
    for (const double distance : {1.0, 30.0, 1000.0, 1e5}) {
      std::vector<Ray<T>> rays;
      while (rays.size() < 20'000) {
        const Vec3d target = point_on_border(mesh, this->any_triangle(mesh), this->random_);
        if (std::max(std::abs(target.x), std::abs(target.y)) > 0.9) continue;  // the sheet's own border
        rays.push_back(ray_towards<T>(normalize(this->any_point(1) + Vec3d(0, 0, 2)) * distance, target));
      }
      this->expect_no_leak(scene_of({mesh}), rays);
    }
  }
}

/// The roundings of this ray's numbers are as unkind as they get: seen through the method it meets the corner
/// at 0, and leaves the corner's box before it enters, by 8u.
TEST(watertight, the_box_of_a_corner_far_away_is_met_where_the_corner_is) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1e-4f, 0, 0}, {0, -1e-4f, 0}};
  mesh.triangles = {{0, 1, 2}};
  const Ray<float> ray{{-0x1.04e368p+0f, -0x1.029a34p+0f, -0x1.f4ceep+0f},
                       {0x1.c9905cp-1f, 0x1.c58e04p-1f, 0x1.b72d0cp+0f}};
  const Triangle<float> triangle{mesh.vertices[0], mesh.vertices[1], mesh.vertices[2]};
  ASSERT_TRUE(WoopWatertight::intersect(ray, WoopWatertight::prepare(triangle)));
  EXPECT_TRUE((ScalarCore<float, WoopWatertight>(scene_of({mesh}), "sah", 4).closest(ray)));
}

/// Of two triangles that share an edge exactly one is met, because doubles decide where floats cannot.
TEST(watertight, a_ray_at_a_shared_edge_meets_one_triangle) {
  std::mt19937 random(4);
  std::uniform_real_distribution<float> uniform(-1, 1);
  const auto point = [&] {
    const float x = uniform(random), y = uniform(random);
    return Vec3f(x, y, uniform(random));
  };
  int both = 0, none = 0;
  for (int i = 0; i < 200'000; ++i) {
    const Vec3f a = point(), b = point(), left = point(), right = point(), origin = point() * 3.0f;
    const Ray<float> ray{origin, normalize(a + (b - a) * std::abs(uniform(random)) - origin)};
    // On either side of the edge as the ray sees it.
    const Vec3f across = cross(a - origin, b - origin);
    if (dot(left - origin, across) * dot(right - origin, across) >= 0) continue;
    const auto hits = [&](const Vec3f& c) { return WoopWatertight::intersect(ray, {a, b, c}).has_value(); };
    both += hits(left) && hits(right);
    none += !hits(left) && !hits(right);
  }
  EXPECT_EQ(both, 0);
  EXPECT_EQ(none, 0);
}

TEST(watertight, a_triangle_without_area_is_never_met) {
  Mesh mesh;  // on a line that rounds to a sliver where the ray sees it
  mesh.vertices = {{0.1f, 0.1f, 0.1f}, {0.2f, 0.2f, 0.2f}, {0.3f, 0.3f, 0.3f}};
  mesh.triangles = {{0, 1, 2}};
  const ScalarCore<float, WoopWatertight> core(scene_of({mesh}), "sah", 4);
  std::mt19937 random(6);
  std::uniform_real_distribution<float> uniform(-1, 1);
  int found = 0, met = 0;
  for (int i = 0; i < 100'000; ++i) {
    const float x = uniform(random), y = uniform(random), along = 0.2f + 0.1f * uniform(random);
    const Ray<float> ray = ray_towards<float>({x, y, uniform(random)}, {along, along, along});
    found +=
        WoopWatertight::intersect(ray, {mesh.vertices[0], mesh.vertices[1], mesh.vertices[2]}).has_value();
    met += core.closest(ray).has_value();
  }
  EXPECT_GT(found, 0) << "by the method alone, which knows no area";
  EXPECT_EQ(met, 0);
}

}  // namespace
}  // namespace raysweep
