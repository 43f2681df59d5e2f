#include "tracer/scene/geodesic.h"

namespace raysweep {

namespace {

constexpr uint32_t corner_count = 12;
constexpr double golden_ratio = 1.618033988749895;

/// Three golden rectangles, each across the two others.
constexpr std::array<Vec3d, corner_count> corners{{{-1, golden_ratio, 0},
                                                   {1, golden_ratio, 0},
                                                   {-1, -golden_ratio, 0},
                                                   {1, -golden_ratio, 0},
                                                   {0, -1, golden_ratio},
                                                   {0, 1, golden_ratio},
                                                   {0, -1, -golden_ratio},
                                                   {0, 1, -golden_ratio},
                                                   {golden_ratio, 0, -1},
                                                   {golden_ratio, 0, 1},
                                                   {-golden_ratio, 0, -1},
                                                   {-golden_ratio, 0, 1}}};

constexpr std::array<std::array<uint32_t, 3>, 20> faces{
    {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
     {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
     {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};

/// A face is a pile of rows: row 0 is its first corner, row `frequency` the edge from its second corner to
/// its third.
class Geodesic {
 public:
  Geodesic(Mesh& mesh, int frequency, const std::function<Vec3d(const Vec3d&)>& place)
      : mesh_(mesh), frequency_(static_cast<uint32_t>(frequency)), place_(place) {
    const size_t count = geodesic_triangle_count(frequency);
    mesh_.vertices.reserve(mesh_.vertices.size() + count / 2 + 2);  // Euler: V = F/2 + 2
    mesh_.triangles.reserve(mesh_.triangles.size() + count);
  }

  void append() {
    first_corner_ = next_vertex();
    for (const Vec3d& corner : corners) append_vertex(corner);
    for (const auto& [a, b, c] : faces) {
      append_edge(a, b);
      append_edge(b, c);
      append_edge(c, a);
    }
    for (const auto& face : faces) append_face(face);
  }

 private:
  [[nodiscard]] uint32_t next_vertex() const { return static_cast<uint32_t>(mesh_.vertices.size()); }

  void append_vertex(const Vec3d& on_icosahedron) {
    mesh_.vertices.emplace_back(place_(normalize(on_icosahedron)));
  }

  /// The vertices between two corners. An edge is there twice, once in each direction: one of them counts.
  void append_edge(uint32_t from, uint32_t to) {
    if (from > to) return;
    first_of_edge_[from][to] = next_vertex();
    for (uint32_t step = 1; step < frequency_; ++step)
      append_vertex(corners[from] * double(frequency_ - step) + corners[to] * double(step));
  }

  /// The vertex `step` steps from one corner towards another.
  [[nodiscard]] uint32_t on_edge(uint32_t from, uint32_t to, uint32_t step) const {
    if (step == 0) return first_corner_ + from;
    if (step == frequency_) return first_corner_ + to;
    return from < to ? first_of_edge_[from][to] + step - 1 : first_of_edge_[to][from] + frequency_ - step - 1;
  }

  void append_face(const std::array<uint32_t, 3>& face) {
    const uint32_t first_inside = next_vertex();
    const Vec3d &a = corners[face[0]], &b = corners[face[1]], &c = corners[face[2]];
    for (uint32_t row = 2; row < frequency_; ++row) {
      for (uint32_t i = 1; i < row; ++i)
        append_vertex(a * double(frequency_ - row) + b * double(row - i) + c * double(i));
    }
    const auto at = [&](uint32_t row, uint32_t i) {
      if (row == frequency_) return on_edge(face[1], face[2], i);
      if (i == 0) return on_edge(face[0], face[1], row);
      if (i == row) return on_edge(face[0], face[2], row);
      return first_inside + (row - 1) * (row - 2) / 2 + i - 1;  // the rows above have 1, 2, … inside
    };
    for (uint32_t row = 0; row < frequency_; ++row) {
      for (uint32_t i = 0; i <= row; ++i) {
        mesh_.triangles.push_back({at(row, i), at(row + 1, i), at(row + 1, i + 1)});
        if (i < row) mesh_.triangles.push_back({at(row, i), at(row + 1, i + 1), at(row, i + 1)});
      }
    }
  }

  Mesh& mesh_;
  uint32_t frequency_, first_corner_ = 0;
  const std::function<Vec3d(const Vec3d&)>& place_;
  std::array<std::array<uint32_t, corner_count>, corner_count> first_of_edge_{};
};

}  // namespace

void append_geodesic(Mesh& mesh, int frequency, const std::function<Vec3d(const Vec3d& direction)>& place) {
  Geodesic(mesh, frequency, place).append();
}

}  // namespace raysweep
