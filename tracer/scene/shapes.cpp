#include "tracer/scene/shapes.h"

#include <numbers>

namespace raysweep {

void append_box(Mesh& mesh, const Vec3d& lower, const Vec3d& upper) {
  // Bits 0, 1 and 2 of a corner's number choose its upper x, y and z.
  static constexpr std::array<std::array<uint32_t, 4>, 6> faces{
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  const auto first = static_cast<uint32_t>(mesh.vertices.size());
  for (uint32_t corner = 0; corner < 8; ++corner) {
    mesh.vertices.emplace_back(Vec3d(corner & 1 ? upper.x : lower.x, corner & 2 ? upper.y : lower.y,
                                     corner & 4 ? upper.z : lower.z));
  }
  for (const auto& [a, b, c, d] : faces) {
    mesh.triangles.push_back({first + a, first + b, first + c});
    mesh.triangles.push_back({first + a, first + c, first + d});
  }
}

void transform(Mesh& mesh, const Placement& placement) {
  const Vec3d angle = placement.rotate * (std::numbers::pi / 180);
  const Vec3d c(std::cos(angle.x), std::cos(angle.y), std::cos(angle.z));
  const Vec3d s(std::sin(angle.x), std::sin(angle.y), std::sin(angle.z));
  for (Vec3f& vertex : mesh.vertices) {
    Vec3d v = Vec3d(vertex) * placement.scale;
    v = {v.x, c.x * v.y - s.x * v.z, s.x * v.y + c.x * v.z};
    v = {c.y * v.x + s.y * v.z, v.y, c.y * v.z - s.y * v.x};
    v = {c.z * v.x - s.z * v.y, s.z * v.x + c.z * v.y, v.z};
    vertex = Vec3f(v + placement.translate);
  }
}

}  // namespace raysweep
