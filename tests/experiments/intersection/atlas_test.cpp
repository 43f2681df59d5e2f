// Maps of failures over two difficulties, and where triangles lie on them.
#include "experiments/intersection/atlas.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace raysweep {
namespace {

const AtlasMap& map_named(std::string_view id) {
  for (const AtlasMap& map : all_atlas_maps()) {
    if (map.id == id) return map;
  }
  throw std::out_of_range(std::string(id));
}

const AtlasGrid& grid_of(const std::vector<AtlasGrid>& grids, std::string_view method) {
  for (const AtlasGrid& grid : grids) {
    if (grid.method == method) return grid;
  }
  throw std::out_of_range(std::string(method));
}

/// The map with these cells alone.
AtlasMap with_cells(AtlasMap map, std::vector<double> x, std::vector<double> y) {
  map.x = std::move(x);
  map.y = std::move(y);
  return map;
}

/// Within a factor of 4.
bool are_near(double value, double expected) { return std::abs(std::log2(value / expected)) < 2; }

/// How many of a cell's triangles lie elsewhere. Doubles know too little of small triangles far away, whose
/// corners they round, and of needles, whose normal rounding turns by ε / altitude. Of a large triangle near
/// the world's origin the middle is anywhere.
size_t strays(const AtlasMap& map, double x, double y) {
  const bool is_size = map.id == "size-offset";
  if (is_size ? x < 1e-6 * y : x * y < 1e-14) return 0;
  const Trials<double> trials = map.row(y).make<double>(x, 1, 20);
  size_t count = 0;
  for (const Trial<double>& trial : trials.rays) {
    const Triangle<double>& triangle = trials.triangles[trials.candidates[trial.first]];
    const AtlasPlace place = map.place(triangle, trial.ray.origin);
    if (!are_near(place.x, x) || (!are_near(place.y, y) && !(is_size && y <= 4 * x))) ++count;
  }
  return count;
}

TEST(Atlas, triangles_lie_in_the_cells_that_they_were_made_for) {
  for (const AtlasMap& map : all_atlas_maps()) {
    for (const double x : map.x) {
      for (const double y : map.y) EXPECT_EQ(strays(map, x, y), 0u) << map.id << " " << x << " " << y;
    }
  }
}

TEST(Atlas, easy_cells_have_hits_and_no_method_but_the_sum_of_angles_misses_one_in_a_hundred) {
  for (const AtlasMap& map : all_atlas_maps()) {
    const AtlasMap easy = with_cells(map, {map.x.front()}, {map.y.front()});
    for (const AtlasGrid& grid : run_atlas<float>(easy, 1, 400)) {
      EXPECT_GT(grid.hits[0][0], 200u) << map.id;
      if (grid.method == "angle_sum") continue;
      EXPECT_LT(grid.false_misses[0][0] * 100, grid.hits[0][0]) << map.id << " " << grid.method;
    }
  }
}

TEST(Atlas, world_coordinates_lose_hits_far_away_where_the_rays_own_do_not) {
  const AtlasMap far = with_cells(map_named("size-offset"), {1}, {std::ldexp(1.0, 20)});
  const auto grids = run_atlas<float>(far, 1, 400);
  const AtlasGrid &world = grid_of(grids, "baldwin_weber"), &own = grid_of(grids, "kensler_shirley");
  EXPECT_GT(world.false_misses[0][0] * 2, world.hits[0][0]);
  EXPECT_LT(own.false_misses[0][0] * 10, own.hits[0][0]);
  const auto finer = run_atlas<double>(far, 1, 400);
  EXPECT_LT(grid_of(finer, "baldwin_weber").false_misses[0][0] * 100,
            grid_of(finer, "baldwin_weber").hits[0][0]);
}

TEST(Atlas, rows_are_y_and_columns_are_x) {
  const AtlasMap map = with_cells(map_named("aspect-grazing"), {1, 0.25}, {1, 0.25, 0.0625});
  for (const AtlasGrid& grid : run_atlas<float>(map, 1, 10)) {
    EXPECT_EQ(grid.hits.size(), 3u);
    EXPECT_EQ(grid.false_misses.back().size(), 2u);
  }
}

/// One mesh seen from (0, 0, 4): a right triangle of edges 3, 4, 5 in the plane z = 0, and one on a line.
Scene one_triangle(size_t copies) {
  Scene scene;
  scene.camera.position = {1, 4.0 / 3, 4};
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {6, 0, 0}};
  mesh.triangles.assign(copies, {0, 1, 2});
  mesh.triangles.push_back({0, 1, 3});
  scene.meshes.push_back(mesh);
  return scene;
}

TEST(Atlas, a_triangle_lies_where_its_size_distance_and_shape_say) {
  Random random(1);
  const auto size = places_of(map_named("size-offset"), one_triangle(1), random, 10);
  ASSERT_GE(size.size(), 1u);
  EXPECT_DOUBLE_EQ(size[0].x, 5.0 / 4);
  EXPECT_DOUBLE_EQ(size[0].y, std::hypot(1, 4.0 / 3) / 4);
  const auto aspect = places_of(map_named("aspect-grazing"), one_triangle(1), random, 10);
  ASSERT_EQ(aspect.size(), 1u) << "one without area has no place";
  EXPECT_DOUBLE_EQ(aspect[0].x, 12.0 / 25);
  EXPECT_NEAR(aspect[0].y, 1, 1e-12);
}

TEST(Atlas, no_more_triangles_are_placed_than_asked_for) {
  Random random(1);
  EXPECT_EQ(places_of(map_named("aspect-grazing"), one_triangle(50), random, 7).size(), 7u);
}

}  // namespace
}  // namespace raysweep
