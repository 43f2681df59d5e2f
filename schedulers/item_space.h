// What is shared out, and in which portions.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>

namespace raysweep {

/// The work of one run: items 0 … count − 1, each independent of the others.
struct ItemSpace {
  size_t count = 0;
  size_t columns = 0;     // items in a row, where they are a grid in row order; 0: they are none
  size_t item_bytes = 0;  // what one item writes; 0: unknown
};

/// Runs items begin … end − 1 as worker 0 ≤ worker < threads. Called from several threads at once, never
/// twice at once for one worker.
using Body = std::function<void(size_t begin, size_t end, int worker)>;

/// How much is handed out at once.
struct Chunk {
  enum class Unit {
    items,       // so many items a chunk
    per_thread,  // so many chunks for each thread
    bytes        // as many items as write so many bytes
  };
  int value = 1;
  Unit unit = Unit::items;

  /// "4", "2/thread" or "4096B".
  [[nodiscard]] std::string text() const {
    return std::to_string(value) + (unit == Unit::per_thread ? "/thread" : unit == Unit::bytes ? "B" : "");
  }

  /// Items a chunk, at least 1. Per-thread chunks are rounded up, so that there are at most `threads · value`
  /// of them; bytes are rounded down.
  [[nodiscard]] size_t size(const ItemSpace& items, int threads) const {
    const auto v = static_cast<size_t>(value);
    if (unit == Unit::items) return v;
    const size_t parts = static_cast<size_t>(threads) * v;
    const size_t size = unit == Unit::per_thread ? (items.count + parts - 1) / parts
                                                 : v / std::max<size_t>(1, items.item_bytes);
    return std::max<size_t>(1, size);
  }
};
inline constexpr int max_chunk = 1 << 24;

/// Where the `part`-th of `parts` near-equal contiguous blocks of `count` items begins.
[[nodiscard]] constexpr size_t block_begin(size_t count, size_t part, size_t parts) {
  return count / parts * part + std::min(part, count % parts);
}

}  // namespace raysweep
