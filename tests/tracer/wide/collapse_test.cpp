// What a collapsed tree promises: every item once, or as often as it was cut, in boxes that hold it, in
// leaves of the asked size.
#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <set>

#include "tests/tracer/shared_work.h"
#include "tracer/accel/build_by_name.h"
#include "tracer/wide/wide_tree.h"

namespace raysweep {
namespace {

std::vector<Box<float>> random_boxes(size_t count, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> at(-5, 5), size(0, 0.4f);
  std::vector<Box<float>> boxes(count);
  for (Box<float>& box : boxes) {
    const float x = at(random), y = at(random), z = at(random);
    const float w = size(random), h = size(random), d = size(random);
    box.include({x, y, z});
    box.include({x + w, y + h, z + d});
  }
  return boxes;
}

bool holds(const Box<float>& outer, const Box<float>& inner) {
  Box<float> both = outer;
  both.include(inner);
  return both.lower() == outer.lower() && both.upper() == outer.upper();
}

/// Walks the whole tree and holds it against its promises.
template <int width>
class Walk {
 public:
  Walk(const WideTree<width>& tree, std::span<const Box<float>> boxes, uint32_t sphere_count)
      : tree_(tree), boxes_(boxes), sphere_count_(sphere_count), seen_(boxes.size()) {
    for (const Box<float>& box : boxes) EXPECT_TRUE(holds(tree.bounds, box));
    visit(0, tree.bounds, 1);
    EXPECT_EQ(deepest_, tree.depth);
    for (const int times : seen_) {
      EXPECT_GE(times, 1) << "each item stands in a leaf";
      EXPECT_TRUE(tree.is_cut || times == 1) << "each item stands in one leaf";
    }
  }

  [[nodiscard]] size_t largest_leaf() const { return largest_leaf_; }
  [[nodiscard]] size_t leaf_count() const { return leaf_count_; }

 private:
  void visit(uint32_t index, const Box<float>& around, int depth) {
    deepest_ = std::max(deepest_, depth);
    const WideNode<width>& node = tree_.nodes[index];
    for (int octant = 0; octant < 8; ++octant) expect_a_permutation(node.far_to_near[octant]);
    for (int i = 0; i < width; ++i) {
      Box<float> box;
      box.bounds[0] = {node.bounds[0][0][i], node.bounds[1][0][i], node.bounds[2][0][i]};
      box.bounds[1] = {node.bounds[0][1][i], node.bounds[1][1][i], node.bounds[2][1][i]};
      if (box.lower().x > box.upper().x) continue;
      EXPECT_TRUE(holds(around, box));
      if ((node.children[i] & leaf_bit) == 0) {
        visit(node.children[i], box, depth + 1);
      } else {
        visit_leaf(node.children[i], box);
      }
    }
  }

  void visit_leaf(WideChild leaf, const Box<float>& around) {
    size_t count = 0;
    std::set<uint32_t> here;
    for (uint32_t b = child_index(leaf);; ++b) {
      EXPECT_NE(b, 0u) << "the sentinel is nobody's leaf";
      for (int lane = 0; lane < width; ++lane) {
        const uint32_t item = tree_.block_items[b * width + static_cast<uint32_t>(lane)];
        if (item == no_hit_id) continue;
        count++;
        seen_[item]++;
        EXPECT_TRUE(here.insert(item).second) << "no item stands in a leaf twice";
        EXPECT_TRUE(tree_.is_cut || holds(around, boxes_[item]));
        EXPECT_EQ((leaf & sphere_bit) != 0, item < sphere_count_) << "leaves hold one kind";
      }
      if (tree_.block_goes_on[b] == 0) break;
    }
    largest_leaf_ = std::max(largest_leaf_, count);
    leaf_count_++;
  }

  static void expect_a_permutation(uint32_t order) {
    uint32_t seen = 0;
    for (int i = 0; i < width; ++i) seen |= 1u << ((order >> (3 * i)) & 7);
    EXPECT_EQ(seen, (1u << width) - 1);
  }

  const WideTree<width>& tree_;
  std::span<const Box<float>> boxes_;
  uint32_t sphere_count_;
  std::vector<int> seen_;
  size_t largest_leaf_ = 0, leaf_count_ = 0;
  int deepest_ = 0;
};

template <int width>
void expect_promises_kept() {
  for (const uint32_t count : {1u, 2u, 7u, 8u, 9u, 64u, 1000u, 20'000u}) {
    for (const uint32_t spheres : {0u, count / 3, count}) {
      const auto boxes = random_boxes(count);
      for (const char* accel : {"sah", "sbvh", "median", "none"}) {
        const bool merges = std::string(accel) == "sah" || std::string(accel) == "sbvh";
        const auto binary = build_by_name<float>(accel, boxes, spheres, 1);
        const auto tree = collapse<width>(binary, boxes, {spheres, merges});
        Walk<width>(tree, boxes, spheres);
      }
    }
  }
}

TEST(collapse, keeps_every_item_once_in_boxes_that_hold_it) {
  expect_promises_kept<4>();
  expect_promises_kept<8>();
}

TEST(collapse, pieces_of_one_item_that_meet_in_a_leaf_are_one) {
  std::vector<Box<float>> boxes(3);
  boxes[0].include({0, 0, 0});
  boxes[0].include({2, 1, 1});
  boxes[1] = boxes[2] = boxes[0];
  boxes[1].bounds[1].x = boxes[2].bounds[0].x = 1;
  const Hierarchy<float> cut{{{boxes[0], 1, 0}, {boxes[1], 0, 2}, {boxes[2], 2, 2}}, {0, 1, 0, 2}};
  const auto tree = collapse<8>(cut, boxes, {0, true});
  EXPECT_TRUE(tree.is_cut);
  const Walk<8> walk(tree, boxes, 0);
  EXPECT_EQ(walk.leaf_count(), 1u);
  EXPECT_EQ(walk.largest_leaf(), 3u);
}

TEST(collapse, merged_leaves_fill_one_block_at_most) {
  const auto boxes = random_boxes(3000);
  const auto tree = collapse<8>(build_sah<float>(boxes, 1), boxes, {0, true});
  const Walk<8> walk(tree, boxes, 0);
  EXPECT_LE(walk.largest_leaf(), 8u);
  EXPECT_GT(walk.largest_leaf(), 4u);
}

TEST(collapse, leaves_of_a_studied_builder_stay_what_they_are) {
  const auto boxes = random_boxes(3000);
  for (const int leaf : {1, 5, 64, 5000}) {
    const auto binary = build_median<float>(boxes, leaf);
    size_t leaves = 0;
    for (const Node<float>& node : binary.nodes) leaves += node.is_leaf() ? 1 : 0;
    const auto tree = collapse<8>(binary, boxes, {0, false});
    const Walk<8> walk(tree, boxes, 0);
    EXPECT_EQ(walk.leaf_count(), leaves) << leaf;
    EXPECT_LE(walk.largest_leaf(), static_cast<size_t>(leaf));
  }
}

TEST(collapse, items_in_one_place_share_a_leaf_of_several_blocks) {
  const std::vector<Box<float>> boxes(100, random_boxes(1)[0]);
  const auto tree = collapse<8>(build_sah<float>(boxes, 1), boxes, {30, true});
  const Walk<8> walk(tree, boxes, 30);
  EXPECT_EQ(walk.leaf_count(), 2u) << "one of spheres, one of triangles";
}

/// A box as large as a room, and what is inside.
TEST(collapse, children_larger_than_half_of_their_node_come_first) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    std::vector<Box<float>> boxes = random_boxes(200, seed);
    boxes.emplace_back();
    boxes.back().include({-6, -6, -6});
    boxes.back().include({6, 6, 6});
    const auto tree = collapse<8>(build_by_name<float>("sah", boxes, 0, 7, 8), boxes, {0, true});
    const WideNode<8>& root = tree.nodes[0];
    const auto half_area = [&](int i) {
      const auto size = [&](int axis) { return root.bounds[axis][1][i] - root.bounds[axis][0][i]; };
      return size(0) * size(1) + size(1) * size(2) + size(2) * size(0);
    };
    EXPECT_GT(half_area(0), tree.bounds.half_area() / 2) << seed;
    for (int i = 1; i < 8; ++i) EXPECT_FALSE(half_area(i) > tree.bounds.half_area() / 2) << seed << ' ' << i;
  }
}

TEST(collapse, nothing_gives_a_root_without_children) {
  const auto tree = collapse<8>(Hierarchy<float>{}, {}, {0, true});
  ASSERT_EQ(tree.nodes.size(), 1u);
  for (int i = 0; i < 8; ++i) EXPECT_GT(tree.nodes[0].bounds[0][0][i], tree.nodes[0].bounds[0][1][i]);
}

TEST(collapse, the_tree_is_the_same_whoever_shares_the_work) {
  const auto boxes = random_boxes(20'000);
  const auto binary = build_sah<float>(boxes, 4);
  const auto tree = collapse<8>(binary, boxes, {1000, true});
  for (const ForEach& for_each : {ForEach(backwards), ForEach(by_threads)}) {
    const auto other = collapse<8>(binary, boxes, {1000, true}, for_each);
    ASSERT_EQ(other.nodes.size(), tree.nodes.size());
    EXPECT_EQ(std::memcmp(other.nodes.data(), tree.nodes.data(), tree.nodes.size() * sizeof(tree.nodes[0])),
              0);
    EXPECT_EQ(other.block_items, tree.block_items);
    EXPECT_EQ(other.block_goes_on, tree.block_goes_on);
    EXPECT_EQ(other.depth, tree.depth);
  }
}

/// A dearer tree would be found by traversal times only.
TEST(collapse, eight_children_cost_less_than_four) {
  const auto boxes = random_boxes(5000);
  const auto binary = build_sah<float>(boxes, 1);
  EXPECT_LT(collapse<8>(binary, boxes, {0, true}).cost, 0.8 * collapse<4>(binary, boxes, {0, true}).cost);
}

}  // namespace
}  // namespace raysweep
