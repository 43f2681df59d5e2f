#include "experiments/item.h"

#include "experiments/numbers.h"

namespace raysweep {

std::optional<ItemShape> parse_item(const std::string& text) {
  if (text == "rows") return ItemShape{ItemShape::Kind::rows, 1};
  if (text == "tiles") return ItemShape{ItemShape::Kind::tiles, default_tile_side};
  constexpr std::string_view prefix = "tiles:";
  if (!text.starts_with(prefix)) return std::nullopt;
  const auto side = parse_number<int>(std::string_view(text).substr(prefix.size()));
  if (!side || *side < 1 || *side > max_tile_side) return std::nullopt;
  return ItemShape{ItemShape::Kind::tiles, *side};
}

}  // namespace raysweep
