// What kernels traverse: a wide tree, its triangles in blocks, and the shapes behind them.
#pragma once

#include "tracer/accel/primitives.h"
#include "tracer/wide/wide_tree.h"

namespace raysweep {

template <class Method, int width>
struct WideGeometry {
  using Block = WideBlock<width>;

  const Primitives<float, Method>* primitives;
  WideTree<width> tree;
  std::vector<Block, CacheLineAllocator<Block>> blocks;

  /// Fills the blocks of `built` with the triangles of `shapes`, which must outlive this.
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
    for (auto& row : block.corners) row[lane] = std::numeric_limits<float>::quiet_NaN();
    block.id[lane] = item == no_hit_id ? no_hit_id : primitives->first_sphere() + item;
    if (block.id[lane] == no_hit_id) return;
    block.count = static_cast<uint32_t>(lane) + 1;
    if (block.id[lane] < primitives->first_triangle()) return;
    const TriangleShape<float>& shape = primitives->triangle_shape(block.id[lane]);
    const auto set_rows = [&](float(*rows)[width], const Vec3f& v) {
      rows[0][lane] = v.x;
      rows[1][lane] = v.y;
      rows[2][lane] = v.z;
    };
    set_rows(block.corners, shape.corners.a);
    set_rows(block.corners + 3, shape.corners.b);
    set_rows(block.corners + 6, shape.corners.c);
    set_rows(block.normal, shape.normal);
  }
};

}  // namespace raysweep
