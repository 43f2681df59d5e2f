#include "tracer/sample/sample_walk.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

namespace raysweep {
namespace {

TEST(sample_walk, takes_every_sample_of_a_tile_once) {
  for (const Tile& tile : {Tile{0, 0, 32, 32}, {3, 5, 1, 1}, {8, 4, 7, 9}, {0, 2, 13, 1}, {5, 0, 1, 6}}) {
    for (const size_t subpixels : {1, 3, 16}) {
      SampleWalk walk(tile, subpixels);
      std::set<std::tuple<int, int, size_t>> seen;
      const size_t count = static_cast<size_t>(tile.width * tile.height) * subpixels;
      for (size_t i = 0; i < count; ++i) {
        EXPECT_TRUE(walk.x >= tile.x && walk.x < tile.x + tile.width);
        EXPECT_TRUE(walk.y >= tile.y && walk.y < tile.y + tile.height);
        seen.insert({walk.x, walk.y, walk.subpixel});
        EXPECT_EQ(walk.next(), (i + 1) % subpixels == 0);
      }
      EXPECT_EQ(seen.size(), count) << tile.width << " x " << tile.height << ", " << subpixels;
    }
  }
}

TEST(sample_walk, sixteen_pixels_are_a_square) {
  SampleWalk walk({8, 8, 32, 32}, 1);
  for (int square = 0; square < 64; ++square) {
    const int x = walk.x, y = walk.y;
    for (int i = 0; i < 16; ++i, walk.next()) {
      EXPECT_EQ(walk.x / 4, x / 4);
      EXPECT_EQ(walk.y / 4, y / 4);
    }
  }
}

}  // namespace
}  // namespace raysweep
