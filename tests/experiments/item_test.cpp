#include "experiments/item.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace raysweep {
namespace {

TEST(item, shapes_are_read_whole) {
  EXPECT_EQ(parse_item("rows")->width, 0);
  EXPECT_EQ(parse_item("columns")->height, 0);
  EXPECT_EQ(parse_item("pixels")->width, 1);
  EXPECT_EQ(parse_item("tiles")->width, 16);
  EXPECT_EQ(parse_item("tiles:8")->height, 8);
  for (const char* bad : {"", "row", "tiles:", "tiles:x", "tiles:8x", "tiles:-1", "tiles:1025"})
    EXPECT_FALSE(parse_item(bad)) << bad;
}

TEST(items, cover_every_pixel_once_in_every_shape_and_order) {
  constexpr int width = 53, height = 37;
  for (const char* shape : {"pixels", "rows", "columns", "tiles", "tiles:7"}) {
    for (const OrderInfo& order : item_orders()) {
      const Items items(*parse_item(shape), std::string(order.name), width, height);
      std::vector<int> covered(static_cast<size_t>(width * height));
      for (size_t i = 0; i < items.count(); ++i) {
        const Tile tile = items.tile(i);
        for (int y = tile.y; y < tile.y + tile.height; ++y) {
          for (int x = tile.x; x < tile.x + tile.width; ++x) covered.at(static_cast<size_t>(y * width + x))++;
        }
      }
      EXPECT_EQ(std::ranges::count(covered, 1), width * height) << shape << " " << order.name;
    }
  }
}

TEST(items, successive_items_touch_along_the_hilbert_curve) {
  const Items items({1, 1}, "hilbert", 16, 16);
  for (size_t i = 1; i < items.count(); ++i) {
    const Tile a = items.tile(i - 1), b = items.tile(i);
    EXPECT_EQ(std::abs(a.x - b.x) + std::abs(a.y - b.y), 1) << i;
  }
}

TEST(items, the_morton_curve_goes_in_z) {
  const Items items({8, 8}, "morton", 32, 32);
  const std::pair<int, int> corners[] = {{0, 0}, {8, 0}, {0, 8}, {8, 8}, {16, 0}};
  for (size_t i = 0; i < std::size(corners); ++i)
    EXPECT_EQ((std::pair(items.tile(i).x, items.tile(i).y)), corners[i]);
}

TEST(items, the_costliest_come_first_and_equals_stay_in_order) {
  Items items({0, 1}, "lpt", 4, 5);
  EXPECT_EQ(items.tile(1).y, 1) << "nothing is known before the first frame";
  const std::vector<float> costs{1, 3, 2, 3, 0};
  items.order_by_cost(costs);
  std::vector<int> rows;
  for (size_t i = 0; i < 5; ++i) rows.push_back(items.tile(i).y);
  EXPECT_EQ(rows, (std::vector<int>{1, 3, 2, 0, 4}));
}

TEST(items, are_a_grid_only_in_scanline_order) {
  EXPECT_EQ(Items({16, 16}, "scanline", 64, 32).space().columns, 4u);
  EXPECT_EQ(Items({16, 16}, "hilbert", 64, 32).space().columns, 0u);
  EXPECT_EQ(Items({16, 16}, "scanline", 64, 32).space().item_bytes, 16u * 16 * 12);
}

TEST(items, those_that_cannot_avoid_it_share_cache_lines) {
  EXPECT_FALSE(shares_cache_lines(*parse_item("rows"), 1000));
  EXPECT_FALSE(shares_cache_lines(*parse_item("tiles:16"), 1024));
  EXPECT_TRUE(shares_cache_lines(*parse_item("tiles:16"), 1000)) << "rows begin anywhere in a line";
  for (const char* shape : {"pixels", "columns", "tiles:8"})
    EXPECT_TRUE(shares_cache_lines(*parse_item(shape), 1024)) << shape;
  const Film film(33, 3);
  EXPECT_EQ(reinterpret_cast<uintptr_t>(film.pixels().data()) % 64, 0u);
}

}  // namespace
}  // namespace raysweep
