#include "experiments/item.h"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>

#include "experiments/numbers.h"

namespace raysweep {

namespace {

constexpr size_t pixel_bytes = sizeof(Vec3f), cache_line = 64;

constexpr std::array orders{
    OrderInfo{"scanline", "row by row, from left to right"},
    OrderInfo{"morton", "along the Z curve: neighbours in the picture are near in the order"},
    OrderInfo{"hilbert", "along the Hilbert curve: successive items always touch"},
    OrderInfo{
        "lpt",
        "longest first, by what each item cost in the last frame; measuring and sorting are in the frame"},
};

/// The bits of x and y by turns (Morton 1966).
uint64_t morton_code(uint32_t x, uint32_t y) {
  uint64_t code = 0;
  for (int bit = 0; bit < 32; ++bit)
    code |= static_cast<uint64_t>(x >> bit & 1) << (2 * bit) | static_cast<uint64_t>(y >> bit & 1)
                                                                   << (2 * bit + 1);
  return code;
}

/// How far along the Hilbert curve that fills a square of `side`, a power of two, (x, y) lies: from the
/// largest quadrant to the smallest, turning what is inside as the curve does.
uint64_t hilbert_code(uint32_t side, uint32_t x, uint32_t y) {
  uint64_t code = 0;
  for (uint32_t half = side / 2; half > 0; half /= 2) {
    const bool right = (x & half) != 0, lower = (y & half) != 0;
    const uint64_t quadrant = right ? (lower ? 2 : 3) : (lower ? 1 : 0);
    code += quadrant * half * half;
    if (lower) continue;
    if (right) {
      x = ~x;
      y = ~y;
    }
    std::swap(x, y);
  }
  return code;
}

/// Scanline indices of a grid, sorted along a curve.
template <class Code>
std::vector<uint32_t> along(int columns, int rows, Code code) {
  std::vector<std::pair<uint64_t, uint32_t>> places;
  places.reserve(static_cast<size_t>(columns) * static_cast<size_t>(rows));
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const auto index = static_cast<uint32_t>(places.size());
      places.emplace_back(code(static_cast<uint32_t>(x), static_cast<uint32_t>(y)), index);
    }
  }
  std::ranges::sort(places);
  std::vector<uint32_t> order;
  order.reserve(places.size());
  for (const auto& place : places) order.push_back(place.second);
  return order;
}

}  // namespace

std::optional<ItemShape> parse_item(const std::string& text) {
  if (text == "pixels") return ItemShape{1, 1};
  if (text == "rows") return ItemShape{0, 1};
  if (text == "columns") return ItemShape{1, 0};
  if (text == "tiles") return ItemShape{default_tile_side, default_tile_side};
  constexpr std::string_view prefix = "tiles:";
  if (!text.starts_with(prefix)) return std::nullopt;
  const auto side = parse_number<int>(std::string_view(text).substr(prefix.size()));
  if (!side || *side < 1 || *side > max_tile_side) return std::nullopt;
  return ItemShape{*side, *side};
}

std::span<const OrderInfo> item_orders() { return orders; }

Items::Items(const ItemShape& shape, const std::string& order, int picture_width, int picture_height)
    : picture_width_(picture_width),
      picture_height_(picture_height),
      item_width_(shape.width > 0 ? shape.width : picture_width),
      item_height_(shape.height > 0 ? shape.height : picture_height),
      columns_((picture_width + item_width_ - 1) / item_width_),
      rows_((picture_height + item_height_ - 1) / item_height_) {
  if (order == "morton") order_ = along(columns_, rows_, morton_code);
  if (order == "hilbert") {
    const uint32_t side = std::bit_ceil(static_cast<uint32_t>(std::max(columns_, rows_)));
    order_ = along(columns_, rows_, [=](uint32_t x, uint32_t y) { return hilbert_code(side, x, y); });
  }
}

ItemSpace Items::space() const {
  const size_t columns = order_.empty() ? static_cast<size_t>(columns_) : 0;
  return {count(), columns,
          pixel_bytes * static_cast<size_t>(item_width_) * static_cast<size_t>(item_height_)};
}

Tile Items::tile(size_t i) const {
  const auto at = static_cast<int>(index(i));
  const int x = at % columns_ * item_width_, y = at / columns_ * item_height_;
  return {x, y, std::min(item_width_, picture_width_ - x), std::min(item_height_, picture_height_ - y)};
}

void Items::order_by_cost(std::span<const float> costs) {
  order_.resize(count());
  std::iota(order_.begin(), order_.end(), 0U);
  std::ranges::stable_sort(order_, std::greater(), [&](uint32_t index) { return costs[index]; });
}

bool shares_cache_lines(const ItemShape& shape, int picture_width) {
  if (shape.width == 0 || shape.width >= picture_width) return false;
  const auto bytes = [](int pixels) { return static_cast<size_t>(pixels) * pixel_bytes; };
  return bytes(shape.width) % cache_line != 0 || bytes(picture_width) % cache_line != 0;
}

}  // namespace raysweep
