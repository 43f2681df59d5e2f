#include "experiments/intersection/index_mesh.h"

namespace raysweep {

IndexMesh sphere_mesh(int around, int rings, double least, double rough, Random& random) {
  IndexMesh mesh;
  const auto vertex = [&](double polar, double azimuth) {
    const Turn up(polar), about(azimuth);
    const double radius = least + rough * uniform(random);
    mesh.vertices.emplace_back(radius * Vec3d(up.sine * about.cosine, up.cosine, up.sine * about.sine));
  };
  vertex(0, 0);
  for (int ring = 1; ring < rings; ++ring)
    for (int i = 0; i < around; ++i) vertex(0.5 * ring / rings, 1.0 * i / around);
  vertex(0.5, 0);
  const auto at = [&](int ring, int i) {
    if (ring == 0) return 0u;
    if (ring == rings) return static_cast<uint32_t>(mesh.vertices.size() - 1);
    return static_cast<uint32_t>(1 + (ring - 1) * around + i % around);
  };
  for (int ring = 0; ring < rings; ++ring) {
    for (int i = 0; i < around; ++i) {
      if (ring > 0) mesh.triangles.push_back({at(ring, i), at(ring, i + 1), at(ring + 1, i)});
      if (ring + 1 < rings) mesh.triangles.push_back({at(ring, i + 1), at(ring + 1, i + 1), at(ring + 1, i)});
    }
  }
  return mesh;
}

IndexMesh sheet_mesh(int side, size_t spacing, Random& random) {
  IndexMesh mesh;
  const auto coordinate = [&](int i, bool is_inside) {
    const double moved = is_inside ? random.sign() * static_cast<double>(random.index((spacing + 3) / 4)) : 0;
    return i * static_cast<double>(spacing) + moved;
  };
  for (int j = 0; j <= side; ++j) {
    for (int i = 0; i <= side; ++i) {
      const bool is_inside = i > 0 && i < side && j > 0 && j < side;
      const double x = coordinate(i, is_inside), y = coordinate(j, is_inside);
      mesh.vertices.emplace_back(x, y, static_cast<double>(random.index(2 * spacing)));
    }
  }
  const auto at = [&](int x, int y) { return static_cast<uint32_t>(y * (side + 1) + x); };
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      mesh.triangles.push_back({at(x, y), at(x + 1, y), at(x, y + 1)});
      mesh.triangles.push_back({at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  }
  return mesh;
}

}  // namespace raysweep
