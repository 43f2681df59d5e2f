#include "tracer/scene/solid.h"

#include <map>
#include <numbers>
#include <numeric>
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

std::vector<std::vector<uint32_t>> connected_parts(const Mesh& mesh) {
  const std::vector<uint32_t> welded = weld(mesh.vertices);
  std::vector<uint32_t> parent(welded.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    parent[root(welded[b])] = root(welded[a]);
    parent[root(welded[c])] = root(welded[a]);
  }
  std::map<uint32_t, size_t> place_of_root;
  std::vector<std::vector<uint32_t>> parts;
  for (uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [place, is_new] = place_of_root.emplace(root(welded[mesh.triangles[i][0]]), parts.size());
    if (is_new) parts.emplace_back();
    parts[place->second].push_back(i);
  }
  return parts;
}

Mesh part_of(const Mesh& mesh, const std::vector<uint32_t>& triangles) {
  Mesh part;
  part.name = mesh.name;
  part.material = mesh.material;
  std::map<uint32_t, uint32_t> places;
  for (const uint32_t i : triangles) {
    std::array<uint32_t, 3> corners{};
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t vertex = mesh.triangles[i][k];
      const auto [place, is_new] = places.emplace(vertex, static_cast<uint32_t>(part.vertices.size()));
      if (is_new) part.vertices.push_back(mesh.vertices[vertex]);
      corners[k] = place->second;
    }
    part.triangles.push_back(corners);
  }
  return part;
}

bool is_closed(const Mesh& mesh) {
  const std::vector<uint32_t> welded = weld(mesh.vertices);
  std::map<std::pair<uint32_t, uint32_t>, int> edges;
  std::map<std::array<uint32_t, 3>, int> faces;  // turned to begin with the lowest corner
  for (const auto& triangle : mesh.triangles) {
    std::array<uint32_t, 3> t{welded[triangle[0]], welded[triangle[1]], welded[triangle[2]]};
    std::rotate(t.begin(), std::ranges::min_element(t), t.end());
    for (size_t i = 0; i < 3; ++i) {
      const uint32_t from = t[i], to = t[(i + 1) % 3];
      if (from < to) edges[{from, to}]++;
      if (from > to) edges[{to, from}]--;
    }
    if (t[1] < t[2]) faces[t]++;
    if (t[1] > t[2]) faces[{t[0], t[2], t[1]}]--;
  }
  const auto is_balanced = [](const auto& entry) { return entry.second == 0; };
  return std::ranges::all_of(edges, is_balanced) && !std::ranges::all_of(faces, is_balanced);
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
