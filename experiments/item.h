// Into which items a picture is cut.
#pragma once

#include <optional>
#include <string>

namespace raysweep {

/// Whole rows, or square tiles with `side` pixels (smaller at the right and lower border).
struct ItemShape {
  enum class Kind { rows, tiles } kind = Kind::rows;
  int side = 1;
};
inline constexpr int default_tile_side = 16, max_tile_side = 1024;

/// "rows", "tiles" or "tiles:SIDE"; none for anything else.
[[nodiscard]] std::optional<ItemShape> parse_item(const std::string& text);

}  // namespace raysweep
