#include "tracer/scene/solid.h"

#include <map>
#include <numbers>
#include <tuple>

namespace raysweep {

namespace {

/// For each vertex the first one at the same place.
std::vector<uint32_t> weld(const std::vector<Vec3f>& vertices) {
  std::map<std::tuple<float, float, float>, uint32_t> first;
  std::vector<uint32_t> welded;
  for (const Vec3f& v : vertices) {
    const auto next = static_cast<uint32_t>(welded.size());
    welded.push_back(first.emplace(std::tuple(v.x, v.y, v.z), next).first->second);
  }
  return welded;
}

/// The solid angle that a triangle covers as seen from the origin, signed by its winding.
double solid_angle(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const double la = length(a), lb = length(b), lc = length(c);
  const double volume = dot(a, cross(b, c));
  const double cosines = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
  return 2 * std::atan2(volume, cosines);
}

}  // namespace

bool is_closed(const Mesh& mesh) {
  const std::vector<uint32_t> welded = weld(mesh.vertices);
  std::map<std::pair<uint32_t, uint32_t>, int> balance;
  for (const auto& triangle : mesh.triangles) {
    for (size_t i = 0; i < 3; ++i) {
      const uint32_t from = welded[triangle[i]], to = welded[triangle[(i + 1) % 3]];
      if (from < to) balance[{from, to}]++;
      if (from > to) balance[{to, from}]--;
    }
  }
  if (mesh.triangles.empty()) return false;
  return std::ranges::all_of(balance, [](const auto& edge) { return edge.second == 0; });
}

double signed_volume(const Mesh& mesh) {
  if (mesh.vertices.empty()) return 0;
  // From a vertex: far from the world's origin the sum would cancel.
  const Vec3d from(mesh.vertices.front());
  double six_volumes = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    six_volumes += dot(Vec3d(mesh.vertices[a]) - from,
                       cross(Vec3d(mesh.vertices[b]) - from, Vec3d(mesh.vertices[c]) - from));
  }
  return six_volumes / 6;
}

bool contains(const Mesh& mesh, const Vec3d& point) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += solid_angle(Vec3d(mesh.vertices[a]) - point, Vec3d(mesh.vertices[b]) - point,
                       Vec3d(mesh.vertices[c]) - point);
  }
  return std::abs(sum) > 2 * std::numbers::pi;  // half of the whole sphere
}

bool contains(const Sphere& sphere, const Vec3d& point) {
  return length(point - sphere.centre) < sphere.radius;
}

bool contains(const Plane& half_space, const Vec3d& point) {
  return dot(half_space.normal, point) + half_space.offset < 0;
}

}  // namespace raysweep
