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
  UnsetVector<Block> blocks;

  /// Fills the blocks of `built` with the triangles of `shapes`, which must outlive this. `for_each` shares
  /// the work.
  WideGeometry(const Primitives<float, Method>& shapes, WideTree<width> built,
               const ForEach& for_each = one_after_the_other)
      : primitives(&shapes), tree(std::move(built)), blocks(tree.block_goes_on.size()) {
    constexpr size_t chunk_size = 128;
    for_each((blocks.size() + chunk_size - 1) / chunk_size, [&](size_t chunk) {
      const size_t end = std::min((chunk + 1) * chunk_size, blocks.size());
      for (size_t b = chunk * chunk_size; b < end; ++b) fill(b);
    });
    // Assigning {} would keep the memory.
    tree.block_items = UnsetVector<uint32_t>();
    tree.block_goes_on = std::vector<uint8_t>();
  }

  /// Whether hits begin in kernels: nobody has asked planes before, as there are none.
  [[nodiscard]] bool begins_hits() const { return primitives->first_sphere() == 0; }

 private:
  void fill(size_t b) {
    Block& block = blocks[b];
    block.count = 0;
    block.more = tree.block_goes_on[b];
    for (size_t lane = 0; lane < width; ++lane) {
      const uint32_t item = tree.block_items[b * width + lane];
      block.id[lane] = item == no_hit_id ? no_hit_id : primitives->first_sphere() + item;
      if (item != no_hit_id) block.count = static_cast<uint32_t>(lane) + 1;
      if (item != no_hit_id && block.id[lane] >= primitives->first_triangle()) {
        set_triangle(block, lane);
      } else {
        for (auto& row : block.corners) row[lane] = std::numeric_limits<float>::quiet_NaN();
        for (auto& row : block.normal) row[lane] = 0;
      }
    }
  }

  void set_triangle(Block& block, size_t lane) const {
    const TriangleShape<float> shape = primitives->triangle_shape(block.id[lane]);
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
