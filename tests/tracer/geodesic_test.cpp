#include "tracer/scene/geodesic.h"

#include <gtest/gtest.h>

#include "tracer/scene/solid.h"

namespace raysweep {
namespace {

Mesh unit_geodesic(int frequency) {
  Mesh mesh;
  append_geodesic(mesh, frequency, [](const Vec3d& direction) { return direction; });
  return mesh;
}

TEST(geodesic, closes_and_winds_outwards_at_every_frequency) {
  for (const int frequency : {1, 2, 3, 4, 17}) {
    const Mesh mesh = unit_geodesic(frequency);
    EXPECT_EQ(mesh.triangles.size(), geodesic_triangle_count(frequency));
    EXPECT_EQ(mesh.vertices.size(), static_cast<size_t>(10 * frequency * frequency + 2)) << "all are shared";
    EXPECT_TRUE(is_closed(mesh)) << frequency;
    EXPECT_EQ(connected_parts(mesh).size(), 1u);
    for (const auto& [a, b, c] : mesh.triangles) {
      ASSERT_GT(dot(Vec3d(mesh.vertices[a]), cross(Vec3d(mesh.vertices[b]), Vec3d(mesh.vertices[c]))), 0);
    }
  }
}

TEST(geodesic, fills_the_sphere_the_better_the_finer) {
  const double sphere = 4.0 / 3 * 3.14159265358979;
  EXPECT_NEAR(signed_volume(unit_geodesic(1)), 2.536150710120, 1e-6) << "the icosahedron in the sphere";
  EXPECT_LT(signed_volume(unit_geodesic(8)), sphere);
  EXPECT_NEAR(signed_volume(unit_geodesic(8)), sphere, 0.02 * sphere);
  EXPECT_NEAR(signed_volume(unit_geodesic(32)), sphere, 0.02 / 16 * sphere) << "the error is of second order";
}

TEST(geodesic, its_triangles_are_of_about_one_size) {
  const Mesh mesh = unit_geodesic(40);
  double smallest = 1, largest = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3d at(mesh.vertices[a]);
    const double area = length(cross(Vec3d(mesh.vertices[b]) - at, Vec3d(mesh.vertices[c]) - at)) / 2;
    smallest = std::min(smallest, area);
    largest = std::max(largest, area);
  }
  EXPECT_LT(largest / smallest, 2);
}

TEST(geodesic, is_appended_to_what_is_there_and_asks_once_for_each_vertex) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  int asked = 0;
  append_geodesic(mesh, 5, [&](const Vec3d& direction) {
    asked++;
    EXPECT_NEAR(length(direction), 1, 1e-15);
    return direction * 3.0;
  });
  EXPECT_EQ(asked, 252);
  EXPECT_EQ(mesh.triangles.size(), 501u);
  for (size_t i = 1; i < mesh.triangles.size(); ++i) {
    for (const uint32_t vertex : mesh.triangles[i]) {
      ASSERT_GE(vertex, 3u);
      ASSERT_LT(vertex, 255u);
    }
  }
}

}  // namespace
}  // namespace raysweep
