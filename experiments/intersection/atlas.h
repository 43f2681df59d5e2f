// The failure atlas: hits that methods miss over two difficulties at once, and where on such a map the
// triangles of a scene lie.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "experiments/intersection/case.h"
#include "results/statistics/random.h"
#include "tracer/scene/scene.h"

namespace raysweep {

/// A point of a map; both coordinates have no unit and are above 0.
struct AtlasPlace {
  double x, y;
};

/// Two difficulties. The cells' values are powers of 4, so that they are the same on every machine.
struct AtlasMap {
  std::string_view id, x_of, y_of;  // what the coordinates are
  std::vector<double> x, y;         // of the middles of the cells, from easy to hard
  Case (*row)(double y);            // its difficulty is x
  /// Where a triangle lies that is seen from `eye`.
  AtlasPlace (*place)(const Triangle<double>& triangle, const Vec3d& eye);
};

/// size-offset and aspect-grazing.
[[nodiscard]] const std::vector<AtlasMap>& all_atlas_maps();

/// What the base variant of one method did on a map. Counts are of trials, row by row as [y][x].
struct AtlasGrid {
  std::string_view method;
  std::vector<std::vector<uint64_t>> hits, false_misses;  // the oracle's hits; those of them that were missed
};

/// One grid a method, in the order of the study's list. Each cell has `ray_count` rays of the same seed. T is
/// float or double.
template <class T>
[[nodiscard]] std::vector<AtlasGrid> run_atlas(const AtlasMap& map, uint64_t seed, size_t ray_count);

/// Triangles of the scene as its camera sees them, at most `most`, each as likely as the others. Those
/// without area or with their middle at the camera have no place and are left out.
[[nodiscard]] std::vector<AtlasPlace> places_of(const AtlasMap& map, const Scene& scene, Random& random,
                                                size_t most);

}  // namespace raysweep
