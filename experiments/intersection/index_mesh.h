// Meshes whose triangles know their neighbours.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include "experiments/intersection/case.h"
#include "experiments/intersection/draw.h"

namespace raysweep {

struct IndexMesh {
  std::vector<Vec3d> vertices;
  std::vector<std::array<uint32_t, 3>> triangles;  // three different vertices each
};

/// A closed sphere of 2·around·(rings − 1) triangles between meridians and parallels, around the y axis, the
/// first meridian in the plane z = 0; radius `least` + U(0, `rough`) at each vertex.
[[nodiscard]] IndexMesh sphere_mesh(int around, int rings, double least, double rough, Random& random);
/// A sheet of 2·side² triangles of integer coordinates over a square: its vertices are `spacing` apart in x
/// and y, those inside moved by less than a quarter of that, and from 0 to 2·spacing − 1 high.
[[nodiscard]] IndexMesh sheet_mesh(int side, size_t spacing, Random& random);

/// A mesh rounded to T, its vertices first moved by `offset`, and the triangles around each vertex.
template <class T>
class MeshOf {
 public:
  MeshOf(const IndexMesh& mesh, const Vec3d& offset) : mesh_(mesh), around_(mesh.vertices.size()) {
    for (const Vec3d& vertex : mesh.vertices) vertices_.emplace_back(vertex + offset);
    for (uint32_t i = 0; i < mesh.triangles.size(); ++i)
      for (const uint32_t vertex : mesh.triangles[i]) around_[vertex].push_back(i);
  }

  [[nodiscard]] const Vec3<T>& vertex(uint32_t i) const { return vertices_[i]; }
  [[nodiscard]] Triangle<T> triangle(uint32_t i) const {
    const auto& corners = mesh_.triangles[i];
    return {vertices_[corners[0]], vertices_[corners[1]], vertices_[corners[2]]};
  }
  [[nodiscard]] std::vector<Triangle<T>> triangles() const {
    std::vector<Triangle<T>> all;
    for (uint32_t i = 0; i < mesh_.triangles.size(); ++i) all.push_back(triangle(i));
    return all;
  }
  /// Those that meet at one of `vertices` at least, in the order of the mesh.
  [[nodiscard]] std::vector<uint32_t> around(std::initializer_list<uint32_t> vertices) const {
    std::vector<uint32_t> found;
    for (const uint32_t v : vertices) found.insert(found.end(), around_[v].begin(), around_[v].end());
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }
  /// A side of a triangle, by two vertices.
  [[nodiscard]] std::pair<uint32_t, uint32_t> any_edge(Random& random) const {
    const auto& corners = mesh_.triangles[random.index(mesh_.triangles.size())];
    const size_t side = random.index(3);
    return {corners[side], corners[(side + 1) % 3]};
  }
  [[nodiscard]] const std::array<uint32_t, 3>& any_triangle(Random& random) const {
    return mesh_.triangles[random.index(mesh_.triangles.size())];
  }

 private:
  const IndexMesh& mesh_;
  std::vector<Vec3<T>> vertices_;
  std::vector<std::vector<uint32_t>> around_;
};

}  // namespace raysweep
