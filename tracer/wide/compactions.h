// Permutations that move chosen lanes to the front.
#pragma once

#include <array>
#include <cstdint>

#include "tracer/wide/wide_tree.h"

namespace raysweep {

/// For each set of 8 lanes their numbers, lowest first, packed as in WideNode::far_to_near; what follows is
/// 0.
inline constexpr std::array<uint32_t, 256> compactions = [] {
  std::array<uint32_t, 256> table{};
  for (uint32_t set = 0; set < 256; ++set) {
    int place = 0;
    for (uint32_t lane = 0; lane < 8; ++lane) {
      if ((set >> lane & 1) == 0) continue;
      table[set] |= lane << place;
      place += WideNode<8>::order_bits;
    }
  }
  return table;
}();

}  // namespace raysweep
