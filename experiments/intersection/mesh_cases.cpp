#include "experiments/intersection/families.h"
#include "experiments/intersection/index_mesh.h"

namespace raysweep {

namespace {

/// A place as a corner and a way from there, and the triangles there. Far from the origin the sum would be
/// rounded to another place, but the corner as seen from a point nearby is not.
template <class T>
struct Aim {
  Vec3<T> corner, onwards;
  std::vector<uint32_t> candidates;
};

template <class T>
Aim<T> at_edge(const MeshOf<T>& mesh, Random& random) {
  const auto [a, b] = mesh.any_edge(random);
  const T share = static_cast<T>(uniform(random));
  return {mesh.vertex(a), (mesh.vertex(b) - mesh.vertex(a)) * share, mesh.around({a, b})};
}

template <class T>
Aim<T> at_corner(const MeshOf<T>& mesh, Random& random) {
  const uint32_t a = mesh.any_edge(random).first;
  return {mesh.vertex(a), {0, 0, 0}, mesh.around({a})};
}

template <class T>
Aim<T> at_inside(const MeshOf<T>& mesh, Random& random) {
  const auto& corners = mesh.any_triangle(random);
  const double u = uniform(random), v = uniform(random) * (1 - u);
  const Vec3<T>&a = mesh.vertex(corners[0]), &b = mesh.vertex(corners[1]), &c = mesh.vertex(corners[2]);
  return {a, (b - a) * static_cast<T>(u) + (c - a) * static_cast<T>(v),
          mesh.around({corners[0], corners[1], corners[2]})};
}

/// Whether `origin` sees the inside of all `triangles` at more than a thousandth of grazing. The surface is
/// then a single layer there, and a ray at an edge hits what is around it even when it misses the edge.
template <class T>
bool faces(const MeshOf<T>& mesh, const std::vector<uint32_t>& triangles, const Vec3<T>& origin) {
  return std::all_of(triangles.begin(), triangles.end(), [&](uint32_t i) {
    const Triangle<T> of_mesh = mesh.triangle(i);
    const Triangle<double> t{Vec3d(of_mesh.a), Vec3d(of_mesh.b), Vec3d(of_mesh.c)};
    const Vec3d normal = cross(t.b - t.a, t.c - t.a), to_plane = t.a - Vec3d(origin);
    return dot(normal, to_plane) > 1e-3 * length(normal) * length(to_plane);
  });
}

/// A rough sphere of 16 meridians and 16 rings around `offset`, from whose middle rays are sent.
/// `aim(mesh, random)` says where to and which triangles are there.
template <class T, class Aim>
void from_inside(Trials<T>& trials, const Vec3d& offset, Random& random, size_t count, const Aim& aim) {
  const IndexMesh sphere = sphere_mesh(16, 16, 2, 1, random);
  const MeshOf<T> mesh(sphere, offset);
  trials.triangles = mesh.triangles();
  while (trials.rays.size() < count) {
    const Vec3<T> origin(point_in_ball(random) * 0.5 + offset);
    const auto at = aim(mesh, random);
    if (faces(mesh, at.candidates, origin))
      trials.add({origin, normalize((at.corner - origin) + at.onwards)}, at.candidates);
  }
}

/// Rays that `aim` sends near, `ulps` of 2 away from there.
template <class Function>
auto beside(Function aim) {
  return [aim](auto& trials, double ulps, Random& random, size_t count) {
    using T = NumberOf<decltype(trials)>;
    from_inside(trials, {0, 0, 0}, random, count, [&](const MeshOf<T>& mesh, Random& draw) {
      auto found = aim(mesh, draw);
      const double distance = 2 * static_cast<double>(std::numeric_limits<T>::epsilon()) * ulps;
      found.onwards += Vec3<T>(any_direction(draw) * distance);
      return found;
    });
  };
}

template <class Function>
auto far_away(Function aim) {
  return [aim](auto& trials, double share, Random& random, size_t count) {
    from_inside(trials, Vec3d(148376, 1234, -223423) * share, random, count, aim);
  };
}

}  // namespace

std::vector<Case> mesh_cases() {
  const auto edge = [](const auto& mesh, Random& random) { return at_edge(mesh, random); };
  const auto corner = [](const auto& mesh, Random& random) { return at_corner(mesh, random); };
  const auto inside = [](const auto& mesh, Random& random) { return at_inside(mesh, random); };
  const std::string_view distance = "distance of the aim, in ulps of 2";
  const std::string_view far = "distance from the origin, in shares of 268,205";
  const std::vector<double> ulps{4096, 256, 16, 1, 0}, shares{0, 1e-4, 1e-3, 1e-2, 0.1, 1};
  return {
      with_maker({.id = "W1",
                  .title = "shared edge of a closed mesh",
                  .source = "Woop, Benthin & Wald 2013",
                  .expectation = Expectation::covered,
                  .difficulty = distance,
                  .difficulties = ulps},
                 beside(edge)),
      with_maker({.id = "W2",
                  .title = "shared corner of a closed mesh",
                  .source = "Woop, Benthin & Wald 2013",
                  .expectation = Expectation::covered,
                  .difficulty = distance,
                  .difficulties = ulps},
                 beside(corner)),
      with_maker({.id = "W3",
                  .title = "two hits at one edge of a closed mesh",
                  .source = "Embree's robust mode, at edges",
                  .expectation = Expectation::decided,
                  .difficulty = distance,
                  .difficulties = ulps},
                 beside(edge)),
      with_maker({.id = "F2",
                  .title = "closed mesh far from the origin, random rays",
                  .source = "a mesh in coordinates of a map",
                  .expectation = Expectation::covered,
                  .difficulty = far,
                  .difficulties = shares},
                 far_away(inside)),
      with_maker({.id = "F2e",
                  .title = "closed mesh far from the origin, shared edges",
                  .source = "F2 with the rays of W1",
                  .expectation = Expectation::covered,
                  .difficulty = far,
                  .difficulties = shares},
                 far_away(edge)),
  };
}

}  // namespace raysweep
