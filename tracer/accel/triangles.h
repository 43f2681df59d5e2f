// Two ways to keep a scene's triangles: at hand, or small.
#pragma once

#include <algorithm>
#include <array>
#include <stdexcept>

#include "tracer/accel/surface.h"
#include "tracer/accel/triangle_faces.h"
#include "tracer/unset_memory.h"

namespace raysweep {

/// By how much of their largest coordinate boxes are grown: computed hits stray a few units in the last place
/// from the surface.
template <class T>
inline constexpr T box_padding = 4 * std::numeric_limits<T>::epsilon();

template <class T>
[[nodiscard]] Box<T> padded(const Box<T>& box) {
  const auto largest = [](const Vec3<T>& v) {
    return larger(larger(std::abs(v.x), std::abs(v.y)), std::abs(v.z));
  };
  const T by = box_padding<T> * larger(largest(box.lower()), largest(box.upper()));
  const Vec3<T> pad(by, by, by);
  Box<T> grown;
  grown.bounds[0] = box.lower() - pad;
  grown.bounds[1] = box.upper() + pad;
  return grown;
}

/// The box inside which hits of a triangle are.
template <class T>
[[nodiscard]] Box<T> box_around(const Triangle<T>& t) {
  const auto least = [](T a, T b, T c) { return smaller(smaller(a, b), c); };
  const auto most = [](T a, T b, T c) { return larger(larger(a, b), c); };
  Box<T> box;
  box.bounds[0] = {least(t.a.x, t.b.x, t.c.x), least(t.a.y, t.b.y, t.c.y), least(t.a.z, t.b.z, t.c.z)};
  box.bounds[1] = {most(t.a.x, t.b.x, t.c.x), most(t.a.y, t.b.y, t.c.y), most(t.a.z, t.b.z, t.c.z)};
  return padded(box);
}

/// Some triangles of a mesh and as large a share of its vertices, and where the mesh's own begin among all.
struct MeshPiece {
  const Mesh* mesh;
  size_t begin, end, first_triangle, first_vertex;
};

template <class T>
[[nodiscard]] Triangle<T> triangle_of(const Mesh& mesh, size_t i) {
  const auto& [a, b, c] = mesh.triangles[i];
  return {Vec3<T>(mesh.vertices[a]), Vec3<T>(mesh.vertices[b]), Vec3<T>(mesh.vertices[c])};
}

/// Ready to use, each triangle with corners of its own: for cores that look at them one by one.
template <class T>
class TrianglesAtHand {
 public:
  void resize(size_t triangles, size_t) {
    shapes_.resize(triangles);
    boxes_.resize(triangles);
  }
  /// Different pieces may be filled at the same time; with them all triangles' `boxes`, where they are asked
  /// for.
  void fill(const MeshPiece& piece, Box<T>* boxes) {
    for (size_t i = piece.begin; i < piece.end; ++i) {
      const Triangle<T> t = triangle_of<T>(*piece.mesh, i);
      shapes_[piece.first_triangle + i] = {TriangleShape<T>(t)};
      boxes_[piece.first_triangle + i] = box_around(t);
      if (boxes != nullptr) boxes[piece.first_triangle + i] = box(piece.first_triangle + i);
    }
  }
  [[nodiscard]] size_t count() const { return shapes_.size(); }
  [[nodiscard]] const Triangle<T>& corners(size_t i) const { return shapes_[i].shape.corners; }
  [[nodiscard]] const TriangleShape<T>& shape(size_t i) const { return shapes_[i].shape; }
  [[nodiscard]] const Box<T>& box(size_t i) const { return boxes_[i]; }

 private:
  /// None is spread over one cache line more than it fills.
  struct alignas(64) Line {
    TriangleShape<T> shape;
  };
  UnsetVector<Line> shapes_;
  UnsetVector<Box<T>> boxes_;
};

/// Less than half as large: vertices are kept once for all triangles that share them, boxes are computed
/// anew. For cores that trace in copies of their own, and ask for a triangle where it is shaded.
template <class T>
class CompactTriangles {
 public:
  void resize(size_t triangles, size_t vertices) {
    if (vertices > std::numeric_limits<uint32_t>::max())
      throw std::length_error("meshes of more than four billion vertices");
    triangles_.resize(triangles);
    vertices_.resize(vertices);
  }
  void fill(const MeshPiece& piece, Box<T>* boxes) {
    const Mesh& mesh = *piece.mesh;
    const auto share = [&](size_t i) { return mesh.vertices.size() * i / mesh.triangles.size(); };
    for (size_t v = share(piece.begin); v < share(piece.end); ++v)
      vertices_[piece.first_vertex + v] = Vec3<T>(mesh.vertices[v]);
    const auto base = static_cast<uint32_t>(piece.first_vertex);
    std::array<Triangle<T>, faces_at_once> some{};
    for (size_t first = piece.begin; first < piece.end; first += faces_at_once) {
      const size_t count = std::min(faces_at_once, piece.end - first);
      for (size_t i = 0; i < count; ++i) some[i] = triangle_of<T>(mesh, first + i);
      const auto faces = wide_faces_of(some);
      for (size_t i = 0; i < count; ++i) {
        const auto& [a, b, c] = mesh.triangles[first + i];
        triangles_[piece.first_triangle + first + i] = {{base + a, base + b, base + c}, faces[i]};
        if (boxes != nullptr) boxes[piece.first_triangle + first + i] = box_around(some[i]);
      }
    }
  }
  [[nodiscard]] size_t count() const { return triangles_.size(); }
  [[nodiscard]] Triangle<T> corners(size_t i) const {
    const auto& [a, b, c] = triangles_[i].corners;
    return {vertices_[a], vertices_[b], vertices_[c]};
  }
  [[nodiscard]] TriangleShape<T> shape(size_t i) const { return {corners(i), triangles_[i].face}; }
  [[nodiscard]] Box<T> box(size_t i) const { return box_around(corners(i)); }

 private:
  struct Stored {
    std::array<uint32_t, 3> corners;  // numbers of vertices
    TriangleFace<T> face;
  };
  UnsetVector<Vec3<T>> vertices_;
  UnsetVector<Stored> triangles_;
};

}  // namespace raysweep
