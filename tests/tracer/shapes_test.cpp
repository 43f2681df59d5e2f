#include "tracer/scene/shapes.h"

#include <gtest/gtest.h>

#include <map>

namespace raysweep {
namespace {

/// What `mesh` encloses, by the divergence theorem; negative if it winds inwards.
double volume(const Mesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += dot(Vec3d(mesh.vertices[a]), cross(Vec3d(mesh.vertices[b]), Vec3d(mesh.vertices[c]))) / 6;
  }
  return sum;
}

TEST(append_box, is_closed_and_winds_outwards) {
  Mesh mesh;
  append_box(mesh, {-1, -1, -1}, {1, 1, 1});
  append_box(mesh, {2, 3, 4}, {4, 6, 8});
  EXPECT_EQ(mesh.triangles.size(), 24u);
  EXPECT_DOUBLE_EQ(volume(mesh), 8 + 24);
  std::map<std::pair<uint32_t, uint32_t>, int> uses;
  for (const auto& t : mesh.triangles) {
    for (size_t i = 0; i < 3; ++i) uses[{t[i], t[(i + 1) % 3]}]++;
  }
  for (const auto& [edge, count] : uses) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(uses.contains({edge.second, edge.first})) << "the neighbour runs the other way";
  }
}

TEST(transform, scales_then_turns_about_x_then_y_then_z_then_moves) {
  Mesh mesh;
  mesh.vertices = {{0, 1, 0}, {1, 0, 0}};
  transform(mesh, {.scale = 2, .rotate = {90, 90, 0}, .translate = {10, 0, 0}});
  EXPECT_NEAR(length(mesh.vertices[0] - Vec3f(12, 0, 0)), 0, 1e-6) << "y to z, then z to x";
  EXPECT_NEAR(length(mesh.vertices[1] - Vec3f(10, 0, -2)), 0, 1e-6) << "x stays, then goes to -z";
  mesh.vertices = {{1, 0, 0}};
  transform(mesh, {.scale = 1, .rotate = {0, 0, 90}, .translate = {}});
  EXPECT_NEAR(length(mesh.vertices[0] - Vec3f(0, 1, 0)), 0, 1e-6);
}

}  // namespace
}  // namespace raysweep
