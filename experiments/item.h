// Into which items a picture is cut, and in which order they are handed out.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "schedulers/item_space.h"
#include "tracer/render.h"

namespace raysweep {

/// Items of `width` × `height` pixels, smaller at the right and lower border; 0: as far as the picture goes.
struct ItemShape {
  int width = 0, height = 1;
};
inline constexpr int default_tile_side = 16, max_tile_side = 1024;

/// "pixels", "rows", "columns", "tiles" or "tiles:SIDE"; none for anything else.
[[nodiscard]] std::optional<ItemShape> parse_item(const std::string& text);

/// The orders that do not depend on what items cost.
enum class ItemOrder { scanline, morton, hilbert };

struct OrderInfo {
  std::string_view name, summary;
};
/// With "lpt", longest first by what each item cost in the last frame; it begins in scanline order.
[[nodiscard]] std::span<const OrderInfo> item_orders();

/// A picture cut into items, each with its place in the order.
class Items {
 public:
  /// `order` is one of `item_orders`.
  Items(const ItemShape& shape, const std::string& order, int picture_width, int picture_height);

  [[nodiscard]] size_t count() const { return static_cast<size_t>(columns_) * static_cast<size_t>(rows_); }
  /// The items as schedulers see them; a grid only where they are in scanline order.
  [[nodiscard]] ItemSpace space() const;
  /// Where item `i` of the order stands in scanline order.
  [[nodiscard]] size_t index(size_t i) const { return order_.empty() ? i : order_[i]; }
  /// The pixels of item `i` of the order.
  [[nodiscard]] Tile tile(size_t i) const;
  /// Longest first, by costs in scanline order; equals stay in that order.
  void order_by_cost(std::span<const float> costs);

 private:
  int picture_width_, picture_height_, item_width_, item_height_, columns_, rows_;
  std::vector<uint32_t> order_;  // scanline index of each; empty: scanline order itself
};

/// Whether two workers write the same cache lines where their items meet inside a row of the film: then they
/// wait for each other's caches (false sharing).
[[nodiscard]] bool shares_cache_lines(const ItemShape& shape, int picture_width);

}  // namespace raysweep
