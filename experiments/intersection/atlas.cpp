#include "experiments/intersection/atlas.h"

#include <algorithm>
#include <cmath>

#include "experiments/intersection/draw.h"
#include "experiments/intersection/families.h"
#include "experiments/intersection/subjects.h"
#include "experiments/intersection/tally.h"

namespace raysweep {

namespace {

/// 4 to the powers from `first` to `last`, upwards or downwards.
std::vector<double> powers_of_4(int first, int last) {
  std::vector<double> powers;
  const int step = first < last ? 1 : -1;
  for (int k = first; k != last + step; k += step) powers.push_back(std::ldexp(1.0, 2 * k));
  return powers;
}

double longest_edge(const Triangle<double>& t) {
  return std::max({length(t.b - t.a), length(t.c - t.b), length(t.a - t.c)});
}
Vec3d middle_of(const Triangle<double>& t) { return (t.a + t.b + t.c) * (1.0 / 3); }

/// A triangle of `size` that is `offset` away from the world's origin, seen from a distance of 1. Far away
/// its corners are rounded to others, and the oracle judges those.
template <class T>
void small_and_far(Trials<T>& trials, double size, double offset, Random& random) {
  const Triangle<double> unit = plain_triangle(random);
  const Triangle<double> there = moved(moved(unit, {0, 0, 0}, size), any_direction(random) * offset);
  const Vec3d target = point_about(there, random);
  const Vec3d from = target + view_of(normal_of(unit), 0.2, random);
  trials.add(aimed(Vec3<T>(from), Vec3<T>(target)), rounded<T>(there));
}

/// A triangle with an edge of 1 and an altitude over it, seen from 8 at a cosine to its normal. The ray goes
/// through the world's origin, where the plane is but for rounding.
template <class T>
void thin_and_grazing(Trials<T>& trials, double altitude, double cosine, Random& random) {
  const Vec3d along = any_direction(random), across = any_tangent(along, random);
  const Triangle<double> needle{{0, 0, 0}, along, along * uniform(random) + across * altitude};
  const Vec3d normal = cross(along, across);
  const double side = random.sign();
  const Vec3d view = any_tangent(normal, random) * std::sqrt(1 - cosine * cosine) + normal * (side * cosine);
  const Vec3<T> direction(view);
  const Vec3d aim = point_about(needle, random);
  trials.add({-direction * T(8), direction}, rounded<T>(moved(needle, -aim)));
}

Case size_row(double offset) {
  return with_each(
      {.id = "size-offset", .expectation = Expectation::decided},
      [offset](auto& trials, double size, Random& random) { small_and_far(trials, size, offset, random); });
}

Case aspect_row(double cosine) {
  return with_each({.id = "aspect-grazing", .expectation = Expectation::decided},
                   [cosine](auto& trials, double altitude, Random& random) {
                     thin_and_grazing(trials, altitude, cosine, random);
                   });
}

AtlasPlace size_place(const Triangle<double>& triangle, const Vec3d& eye) {
  const Vec3d middle = middle_of(triangle);
  const double distance = length(middle - eye);
  return {longest_edge(triangle) / distance, length(middle) / distance};
}

AtlasPlace aspect_place(const Triangle<double>& triangle, const Vec3d& eye) {
  const Vec3d normal = cross(triangle.b - triangle.a, triangle.c - triangle.a);
  const Vec3d view = middle_of(triangle) - eye;
  const double edge = longest_edge(triangle);
  return {length(normal) / (edge * edge), std::abs(dot(normal, view)) / (length(normal) * length(view))};
}

bool lies_somewhere(const AtlasPlace& place) {
  return std::isfinite(place.x) && std::isfinite(place.y) && place.x > 0 && place.y > 0;
}

/// Where the triangles of a mesh lie, those without a place left out.
void add_places(std::vector<AtlasPlace>& places, const AtlasMap& map, const Mesh& mesh, const Vec3d& eye) {
  for (const auto& [a, b, c] : mesh.triangles) {
    const Triangle<double> triangle{Vec3d(mesh.vertices[a]), Vec3d(mesh.vertices[b]),
                                    Vec3d(mesh.vertices[c])};
    const AtlasPlace place = map.place(triangle, eye);
    if (lies_somewhere(place)) places.push_back(place);
  }
}

}  // namespace

const std::vector<AtlasMap>& all_atlas_maps() {
  static const std::vector<AtlasMap> maps{
      {"size-offset", "longest edge / length of the ray",
       "distance from the world's origin / length of the ray", powers_of_4(0, -14), powers_of_4(-3, 11),
       size_row, size_place},
      {"aspect-grazing", "altitude / longest edge", "cosine of the ray to the normal", powers_of_4(0, -14),
       powers_of_4(0, -14), aspect_row, aspect_place}};
  return maps;
}

template <class T>
std::vector<AtlasGrid> run_atlas(const AtlasMap& map, uint64_t seed, size_t ray_count) {
  std::vector<Subject<T>> bases = all_subjects<T>();
  std::erase_if(bases, [](const Subject<T>& subject) { return subject.change != "base"; });
  std::vector<AtlasGrid> grids;
  for (const Subject<T>& subject : bases) {
    const std::vector<std::vector<uint64_t>> zeros(map.y.size(), std::vector<uint64_t>(map.x.size()));
    grids.push_back({subject.method, zeros, zeros});
  }
  for (size_t row = 0; row < map.y.size(); ++row) {
    const Case one = map.row(map.y[row]);
    for (size_t column = 0; column < map.x.size(); ++column) {
      const JudgedTrials<T> judged(one, map.x[column], seed, ray_count);
      for (size_t i = 0; i < bases.size(); ++i) {
        const Tally tally = tally_of(judged, bases[i].find_hits(judged.trials), bases[i].variant.output);
        grids[i].hits[row][column] = tally.hits;
        grids[i].false_misses[row][column] = tally.false_misses;
      }
    }
  }
  return grids;
}
template std::vector<AtlasGrid> run_atlas<float>(const AtlasMap&, uint64_t, size_t);
template std::vector<AtlasGrid> run_atlas<double>(const AtlasMap&, uint64_t, size_t);

std::vector<AtlasPlace> places_of(const AtlasMap& map, const Scene& scene, Random& random, size_t most) {
  std::vector<AtlasPlace> places;
  for (const Mesh& mesh : scene.meshes) add_places(places, map, mesh, scene.camera.position);
  // The first of a shuffled list.
  const size_t count = std::min(most, places.size());
  for (size_t i = 0; i < count; ++i) std::swap(places[i], places[i + random.index(places.size() - i)]);
  places.resize(count);
  return places;
}

}  // namespace raysweep
