// What kernels traverse: a wide tree, its triangles in blocks, and the shapes behind them.
#pragma once

#include <cstring>
#include <type_traits>

#include "tracer/accel/primitives.h"
#include "tracer/wide/wide_tree.h"

namespace raysweep {

/// Floats that `Method` prepares for a triangle: nothing but floats.
template <class Method>
inline constexpr int prepared_rows = static_cast<int>(sizeof(typename Method::template Prepared<float>) /
                                                      sizeof(float));

template <class Method, int width>
struct WideGeometry {
  using Block = WideBlock<width, prepared_rows<Method>>;

  const Primitives<float, Method>* primitives;
  WideTree<width> tree;
  std::vector<Block, CacheLineAllocator<Block>> blocks;

  /// Fills the blocks of `built` with the prepared triangles of `shapes`, which must outlive this.
  WideGeometry(const Primitives<float, Method>& shapes, WideTree<width> built)
      : primitives(&shapes), tree(std::move(built)), blocks(tree.block_goes_on.size()) {
    for (size_t b = 0; b < blocks.size(); ++b) {
      blocks[b].more = tree.block_goes_on[b];
      for (size_t lane = 0; lane < width; ++lane)
        set_lane(blocks[b], lane, tree.block_items[b * width + lane]);
    }
    // Assigning {} would keep the memory.
    tree.block_items = std::vector<uint32_t>();
    tree.block_goes_on = std::vector<uint8_t>();
  }

 private:
  void set_lane(Block& block, size_t lane, uint32_t item) const {
    using Prepared = typename Method::template Prepared<float>;
    static_assert(std::is_trivially_copyable_v<Prepared> && sizeof(Prepared) % sizeof(float) == 0);
    block.id[lane] = item == no_hit_id ? no_hit_id : primitives->first_sphere() + item;
    if (block.id[lane] == no_hit_id || block.id[lane] < primitives->first_triangle()) return;
    float row[prepared_rows<Method>];
    std::memcpy(row, &primitives->triangle(block.id[lane]), sizeof(row));
    for (size_t r = 0; r < prepared_rows<Method>; ++r) block.data[r][lane] = row[r];
  }
};

}  // namespace raysweep
