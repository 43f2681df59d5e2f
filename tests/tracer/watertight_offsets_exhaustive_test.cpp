// A million rays at edges and corners of a closed mesh, at the origin, a thousand away and where a map has it
// (case F2 of the failure catalogue): none passes, by brute force and through each hierarchy, alone and in
// packets, on every instruction set.
#include <gtest/gtest.h>

#include "tests/tracer/edge_rays.h"
#include "tests/tracer/wide/batches.h"
#include "tracer/accel/m11.h"
#include "tracer/intersect/all.h"

namespace raysweep {
namespace {

constexpr size_t ray_count = 350'000;  // at each of three places

constexpr const char* accels[] = {"sah", "median", "sbvh", "none"};

/// The closed mesh around `offset`, its vertices rounded there.
Mesh sphere_at(const Vec3d& offset) {
  std::mt19937 random(11);
  Mesh mesh = rough_sphere(16, 16, random);
  for (Vec3f& vertex : mesh.vertices) vertex = Vec3f(Vec3d(vertex) + offset);
  return mesh;
}

/// From around the middle of `mesh`, sixteen from the same place to the border of one triangle, so that they
/// can go together. Aims are sums of a way to a corner and a way from there: far from the origin a place
/// between corners would be rounded to another one.
template <class T>
std::vector<Ray<T>> rays_inside(const Mesh& mesh, const Vec3d& offset) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Ray<T>> rays;
  while (rays.size() < ray_count) {
    const double x = uniform(random) - 0.5, y = uniform(random) - 0.5;
    const Vec3<T> origin(Vec3d(x, y, uniform(random) - 0.5) + offset);
    const auto& triangle = mesh.triangles[random() % mesh.triangles.size()];
    for (size_t i = 0; i < packet_size; ++i) {
      const size_t corner = random() % 3;
      const Vec3<T> a(mesh.vertices[triangle[corner]]), b(mesh.vertices[triangle[(corner + 1) % 3]]);
      const T share = i % 4 == 0 ? 0 : static_cast<T>(uniform(random));
      rays.push_back({origin, normalize((a - origin) + (b - a) * share)});
    }
  }
  return rays;
}

template <class Core, class T>
size_t count_leaks(const Core& core, const std::vector<Ray<T>>& rays) {
  return static_cast<size_t>(
      std::ranges::count_if(rays, [&](const Ray<T>& ray) { return !core.closest(ray); }));
}

/// Of the cores that take a ray at a time.
template <class T, class Method>
void expect_no_leaks(const Scene& scene, const std::vector<Ray<T>>& rays) {
  for (const char* accel : accels) {
    const size_t leaks = count_leaks(ScalarCore<T, Method>(scene, accel, 4), rays);
    if (Method::is_watertight) {
      EXPECT_EQ(leaks, 0u) << Method::name << ' ' << accel << " of " << rays.size();
    } else {
      EXPECT_GT(leaks, 0u) << Method::name << ' ' << accel << ": are these rays at edges?";
      return;
    }
  }
  EXPECT_EQ(count_leaks(M11Core<T, Method>(scene, "median", 4), rays), 0u);
}

/// Of the core wide, which finds what the scalar one finds, and that by brute force, too.
template <class Method>
void expect_the_same_wide(const Scene& scene, const std::vector<Ray<float>>& rays) {
  std::vector<TestRay<float>> tests;
  for (const Ray<float>& ray : rays) tests.push_back({ray, std::numeric_limits<float>::infinity()});
  const Answers expected(ScalarCore<float, Method>(scene, "sah", 4), tests);
  for (const char* accel : {"median", "sah", "sbvh"}) {
    for_each_wide_core<Method>(scene, accel, 4, [&](const auto& core, std::string_view isa) {
      EXPECT_EQ(count_differences(core, expected, tests), 0u) << Method::name << ' ' << accel << ' ' << isa;
    });
  }
}

class WatertightAt : public testing::TestWithParam<std::pair<const char*, Vec3d>> {};
INSTANTIATE_TEST_SUITE_P(places, WatertightAt,
                         testing::Values(std::pair("the_origin", Vec3d(0, 0, 0)),
                                         std::pair("a_thousand", Vec3d(1000, 1000, 1000)),
                                         std::pair("f2", Vec3d(148376, 1234, -223423))),
                         [](const auto& info) { return info.param.first; });

TEST_P(WatertightAt, no_ray_leaves_at_an_edge_or_a_corner) {
  const Vec3d offset = GetParam().second;
  const Mesh mesh = sphere_at(offset);
  const Scene scene = scene_of({mesh});
  const auto floats = rays_inside<float>(mesh, offset);
  const auto doubles = rays_inside<double>(mesh, offset);
  for_each_method([&](auto method) {
    using Method = decltype(method);
    expect_no_leaks<float, Method>(scene, floats);
    expect_no_leaks<double, Method>(scene, doubles);
    if (Method::is_watertight) expect_the_same_wide<Method>(scene, floats);
  });
}

}  // namespace
}  // namespace raysweep
