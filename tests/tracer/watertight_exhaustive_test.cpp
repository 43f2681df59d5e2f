// A million rays at edges and corners of each closed mesh, from outside and from inside: none passes.
#include "tests/tracer/edge_rays.h"
#include "tests/tracer/rock_scenes.h"
#include "tests/tracer/wide/batches.h"
#include "tracer/intersect/all.h"
#include "tracer/scene/grotto.h"
#include "tracer/scene/pebble.h"

namespace raysweep {
namespace {

constexpr size_t ray_count = 1'000'000;

Vec3d any_point(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const double x = uniform(random), y = uniform(random);
  return {x, y, uniform(random)};
}

Vec3d normal_of(const Mesh& mesh, const std::array<uint32_t, 3>& triangle) {
  const Vec3d a(mesh.vertices[triangle[0]]), b(mesh.vertices[triangle[1]]), c(mesh.vertices[triangle[2]]);
  return cross(b - a, c - a);
}

/// The normals of all triangles at each vertex.
std::vector<std::vector<Vec3d>> normals_at_vertices(const Mesh& mesh) {
  std::vector<std::vector<Vec3d>> normals(mesh.vertices.size());
  for (const auto& triangle : mesh.triangles) {
    for (const uint32_t vertex : triangle) normals[vertex].push_back(normal_of(mesh, triangle));
  }
  return normals;
}

/// From points that `make_origin(random)` makes to the borders of triangles of `mesh`, as far as
/// `is_wanted(direction, triangle)`.
template <class MakeOrigin, class IsWanted>
std::vector<TestRay<float>> rays_at(const Mesh& mesh, MakeOrigin&& make_origin, IsWanted&& is_wanted) {
  std::mt19937 random(1);
  std::vector<TestRay<float>> rays;
  while (rays.size() < ray_count) {
    const auto& triangle = mesh.triangles[random() % mesh.triangles.size()];
    const Vec3d origin = make_origin(random), target = point_on_border(mesh, triangle, random);
    if (is_wanted(target - origin, triangle))
      rays.push_back({ray_towards<float>(origin, target), std::numeric_limits<float>::infinity()});
  }
  return rays;
}

/// `is_leak(core, ray)` for none of the rays with a watertight method, but for some with the others; and
/// every core wide answers as the scalar one does.
template <class IsLeak>
void expect_no_leak(const Scene& scene, const std::vector<TestRay<float>>& rays, IsLeak&& is_leak) {
  for_each_method([&](auto method) {
    using Method = decltype(method);
    const ScalarCore<float, Method> core(scene, "sah", 4);
    const auto leaks =
        std::ranges::count_if(rays, [&](const TestRay<float>& test) { return is_leak(core, test.ray); });
    testing::Test::RecordProperty(std::string(method.name), static_cast<int>(leaks));
    if (!method.is_watertight) {
      EXPECT_GT(leaks, 0) << method.name << ": are these rays at edges?";
      return;
    }
    EXPECT_EQ(leaks, 0) << method.name;
    const Answers expected(core, rays);
    for_each_wide_core<Method>(scene, "sah", 4, [&](const auto& wide, std::string_view isa) {
      EXPECT_EQ(count_differences(wide, expected, rays), 0u) << isa;
    });
  });
}

/// Into the stone, away from its outline: all triangles about face the ray.
TEST(watertight, no_ray_enters_a_pebble_at_an_edge_or_a_corner) {
  const Scene scene = make_pebble(1);
  const auto normals = normals_at_vertices(scene.meshes[0]);
  const auto from_outside = [](std::mt19937& random) {
    const Vec3d p = any_point(random);
    return normalize(p) * (4 + 100 * p.x * p.x);
  };
  const auto all_face = [&](const Vec3d& direction, const std::array<uint32_t, 3>& triangle) {
    return std::ranges::all_of(triangle, [&](uint32_t vertex) {
      return std::ranges::all_of(normals[vertex], [&](const Vec3d& n) { return dot(n, direction) < 0; });
    });
  };
  const auto rays = rays_at(scene.meshes[0], from_outside, all_face);
  expect_no_leak(scene, rays, [](const auto& core, const Ray<float>& ray) {
    const auto hit = core.closest(ray);
    return !hit || !core.primitives().surface(ray, *hit).against;
  });
}

/// Out of the room.
TEST(watertight, no_ray_leaves_a_grotto_at_an_edge_or_a_corner) {
  const Scene scene = make_grotto(1);
  const auto anywhere_in_the_room = [&](std::mt19937& random) {
    for (;;) {
      const Vec3d p = any_point(random) * 4;
      if (contains(scene.meshes[0], p)) return p;
    }
  };
  const auto rays =
      rays_at(scene.meshes[0], anywhere_in_the_room, [](const Vec3d&, const auto&) { return true; });
  expect_no_leak(scene, rays, [](const auto& core, const Ray<float>& ray) { return !core.closest(ray); });
}

}  // namespace
}  // namespace raysweep
