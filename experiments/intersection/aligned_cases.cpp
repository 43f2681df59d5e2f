#include "experiments/intersection/families.h"
#include "experiments/intersection/index_mesh.h"

namespace raysweep {

namespace {

/// The first ray is that of the report; others lead from the same place to other points of the diagonal.
template <class T>
void quad_diagonal(Trials<T>& trials, double half, Random& random, size_t count) {
  const T s = static_cast<T>(half);
  trials.triangles = {{{-s, -s, 0}, {s, -s, 0}, {s, s, 0}}, {{-s, -s, 0}, {s, s, 0}, {-s, s, 0}}};
  const Vec3<T> origin(0, 0, 10);
  trials.add({origin, {T(.30458447), T(.30458447), T(-.9024725)}}, {0, 1});
  while (trials.rays.size() < count) {
    const T along = s * static_cast<T>(0.99 * (2 * uniform(random) - 1));
    trials.add(aimed(origin, {along, along, 0}), {0, 1});
  }
}

/// Rodrigues' formula around (1, 1, 1).
Vec3d turned(const Vec3d& p, const Turn& turn) {
  const Vec3d axis = Vec3d(1, 1, 1) * (1 / std::sqrt(3.0));
  return p * turn.cosine + cross(axis, p) * turn.sine + axis * (dot(axis, p) * (1 - turn.cosine));
}

template <class T>
void turned_quad(Trials<T>& trials, double degrees, Random& random, size_t count) {
  const Turn turn(degrees / 360);
  const auto corner = [&](double x, double y) { return Vec3<T>(turned({x, y, 0}, turn)); };
  const Vec3<T> a = corner(-1, -1), b = corner(1, -1), c = corner(1, 1), d = corner(-1, 1);
  trials.triangles = {{a, b, c}, {a, c, d}};
  const Vec3d normal = turned({0, 0, 1}, turn);
  while (trials.rays.size() < count) {
    const Vec3<T> target = a + (c - a) * static_cast<T>(0.01 + 0.98 * uniform(random));
    trials.add(aimed(Vec3<T>(view_of(normal, 0.2, random) * 4), target), {0, 1});
  }
}

/// Seen from the z axis, the meridian a quarter around stands in the plane x = 0, which the rays do not
/// leave.
template <class T>
void aligned_camera(Trials<T>& trials, double shift, Random& random, size_t count) {
  constexpr int columns = 32, rings = 16, pixels = 512;
  const IndexMesh sphere = sphere_mesh(columns, rings, 1, 0, random);
  const MeshOf<T> mesh(sphere, {0, 0, 0});
  trials.triangles = mesh.triangles();
  const Vec3<T> camera(0, 0, 4);
  while (trials.rays.size() < count) {
    // Rings 2 to 14: the rest is seen too flatly from there.
    const auto ring = static_cast<uint32_t>(1 + random.index(rings - 4));
    const uint32_t upper = 1 + ring * columns + columns / 4, lower = upper + columns;
    Vec3<T> target = mesh.vertex(upper);
    if (random.index(4) != 0) target += (mesh.vertex(lower) - target) * static_cast<T>(uniform(random));
    target.x += static_cast<T>(2 * shift / pixels);
    trials.add({camera, target - camera}, mesh.around({upper, lower}));
  }
}

/// Straight down on corners, and on the lattice's points that are nearest to points of edges.
template <class T>
void lattice_mesh(Trials<T>& trials, double bits, Random& random, size_t count) {
  constexpr int side = 15;
  const size_t spacing = size_t{1} << (static_cast<int>(bits) - 4);
  const IndexMesh sheet = sheet_mesh(side, spacing, random);
  const MeshOf<T> mesh(sheet, {0, 0, 0});
  trials.triangles = mesh.triangles();
  const T border = static_cast<T>(side * spacing), height = static_cast<T>(2 * spacing);
  const auto is_inside = [&](T p) { return p > 0 && p < border; };
  while (trials.rays.size() < count) {
    const auto [from, to] = mesh.any_edge(random);
    const T share = random.index(3) == 0 ? T(0) : static_cast<T>(uniform(random));
    const Vec3<T> target = mesh.vertex(from) + (mesh.vertex(to) - mesh.vertex(from)) * share;
    const T x = std::nearbyint(target.x), y = std::nearbyint(target.y);
    if (is_inside(x) && is_inside(y)) trials.add({{x, y, height}, {0, 0, -1}}, mesh.around({from, to}));
  }
}

}  // namespace

std::vector<Case> aligned_cases() {
  return {
      with_maker({.id = "W4",
                  .title = "diagonal of a square",
                  .source = "a bug report's ray at two triangles of 10 by 10",
                  .expectation = Expectation::covered,
                  .difficulty = "half the square's side",
                  .difficulties = {5, 50, 500}},
                 [](auto& trials, double half, Random& random, size_t count) {
                   quad_diagonal(trials, half, random, count);
                 }),
      with_maker({.id = "W5",
                  .title = "diagonal of a turned square",
                  .source = "a test of Mitsuba 3",
                  .expectation = Expectation::covered,
                  .difficulty = "turn about (1,1,1), in degrees",
                  .difficulties = {0, 30, 60, 90}},
                 [](auto& trials, double degrees, Random& random, size_t count) {
                   turned_quad(trials, degrees, random, count);
                 }),
      with_maker({.id = "W6",
                  .title = "camera in the plane of a meridian",
                  .source = "holes that half a pixel's shift removes",
                  .expectation = Expectation::covered,
                  .difficulty = "shift beside the meridian, in pixels",
                  .difficulties = {0.5, 0.25, 1e-3, 1e-6, 0}},
                 [](auto& trials, double shift, Random& random, size_t count) {
                   aligned_camera(trials, shift, random, count);
                 }),
      with_maker({.id = "W7",
                  .title = "axis-parallel rays on the lattice of an integer mesh",
                  .source = "tinybvh issue 168",
                  .expectation = Expectation::covered,
                  .difficulty = "bits of the coordinates",
                  .difficulties = {8, 12, 16, 20, 24}},
                 [](auto& trials, double bits, Random& random, size_t count) {
                   lattice_mesh(trials, bits, random, count);
                 }),
  };
}

}  // namespace raysweep
