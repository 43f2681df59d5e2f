// Pictures by a few threads are the picture; differences are counted bit for bit.
#include "experiments/peers/picture_maker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/tracer/variants.h"
#include "tracer/scene/scenes.h"

namespace raysweep {
namespace {

TEST(picture_maker, makes_the_picture_with_any_count_of_threads) {
  const Scene scene = load_scene("many-lights", 2);
  RenderSettings settings;
  settings.width = 2 * picture_tile + 7;  // tiles that are cut off at both edges
  settings.height = picture_tile + 3;
  settings.core = "wide";
  const Film expected = picture_of(scene, settings);
  for (const int threads : {1, 2, 3}) {
    PictureMaker maker(make_renderer(scene, settings), settings.width, settings.height, threads);
    EXPECT_EQ(maker.tile_count(), 6u);
    EXPECT_GT(maker.run(), 0);
    EXPECT_EQ(maker.film().hash(), expected.hash()) << threads << " threads";
  }
}

TEST(picture_maker, makes_every_so_many_tiles_alone) {
  Scene scene = load_scene("many-lights", 1);
  scene.background = {1, 1, 1};
  scene.planes.clear();
  scene.spheres.clear();
  RenderSettings settings;
  settings.width = 5 * picture_tile;
  settings.height = 1;
  PictureMaker maker(make_renderer(scene, settings), settings.width, settings.height, 2);
  (void)maker.run(2);
  for (int tile = 0; tile < 5; ++tile)
    EXPECT_EQ(maker.film().at(tile * picture_tile, 0).x, tile % 2 == 0 ? 1.0f : 0.0f) << tile;
}

TEST(pixel_differences, are_counted_and_the_largest_kept) {
  Film a(4, 1), b(4, 1);
  EXPECT_EQ(pixel_differences(a, b).pixels, 0u);
  b.at(1, 0) = {0, -0.25f, 0.125f};
  b.at(2, 0).z = std::numeric_limits<float>::denorm_min();
  EXPECT_EQ(pixel_differences(a, b).pixels, 2u);
  EXPECT_EQ(pixel_differences(a, b).largest, 0.25);
  a.at(3, 0).x = b.at(3, 0).x = std::nanf("");
  EXPECT_EQ(pixel_differences(a, b).pixels, 2u) << "no number in both";
  b.at(3, 0).x = 0;
  EXPECT_EQ(pixel_differences(a, b).largest, std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace raysweep
