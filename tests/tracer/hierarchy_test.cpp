#include "tracer/accel/hierarchy.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "tests/tracer/scattered_boxes.h"
#include "tracer/accel/build_by_name.h"

namespace raysweep {
namespace {

bool encloses(const Box<float>& outer, const Box<float>& inner) {
  return min(outer.lower(), inner.lower()) == outer.lower() &&
         max(outer.upper(), inner.upper()) == outer.upper();
}

bool touches(const Box<float>& a, const Box<float>& b) {
  return max(a.lower(), b.lower()) == min(max(a.lower(), b.lower()), min(a.upper(), b.upper()));
}

/// Visits every node; returns the greatest depth. Checks that boxes enclose what is below them; where items
/// may be cut, leaves hold a part of each.
int check(const Hierarchy<float>& tree, const std::vector<Box<float>>& items, bool may_cut) {
  std::multiset<uint32_t> seen;
  const std::function<int(uint32_t)> visit = [&](uint32_t index) -> int {
    const Node<float>& node = tree.nodes[index];
    if (node.is_leaf()) {
      std::set<uint32_t> here;
      for (uint32_t i = node.first; i < node.first + node.count; ++i) {
        seen.insert(tree.order[i]);
        here.insert(tree.order[i]);
        const Box<float>& item = items[tree.order[i]];
        EXPECT_TRUE(may_cut ? touches(node.box, item) : encloses(node.box, item));
      }
      EXPECT_EQ(here.size(), node.count) << "an item stands twice in one leaf";
      return 0;
    }
    for (const uint32_t child : {node.first, node.first + 1})
      EXPECT_TRUE(encloses(node.box, tree.nodes[child].box));
    return 1 + std::max(visit(node.first), visit(node.first + 1));
  };
  const int depth = visit(0);
  if (may_cut) {
    EXPECT_LE(seen.size(), items.size() + items.size() / 2);
  } else {
    EXPECT_EQ(seen.size(), items.size()) << "an item stands in two leaves";
  }
  EXPECT_EQ(std::set<uint32_t>(seen.begin(), seen.end()).size(), items.size()) << "an item is in no leaf";
  EXPECT_LE(depth, max_hierarchy_depth);
  return depth;
}

class Builder : public testing::TestWithParam<const char*> {
 public:
  static Hierarchy<float> build(const std::vector<Box<float>>& items, int leaf_size) {
    return build_by_name<float>(GetParam(), items, 0, leaf_size);
  }
  static void check(const Hierarchy<float>& tree, const std::vector<Box<float>>& items) {
    raysweep::check(tree, items, GetParam() == std::string("sbvh"));
  }
};
INSTANTIATE_TEST_SUITE_P(all, Builder, testing::Values("median", "sah", "sbvh"),
                         [](const auto& info) { return info.param; });

TEST_P(Builder, every_item_is_in_a_leaf_inside_its_boxes) {
  for (const int count : {1, 2, 3, 10, 1000, 20'000}) {
    for (const int leaf_size : {1, 4, 17, 5000}) {
      const auto items = scattered(count);
      const auto tree = build(items, leaf_size);
      check(tree, items);
      EXPECT_LE(largest_leaf(tree), static_cast<uint32_t>(leaf_size));
    }
  }
}

TEST_P(Builder, no_items_make_no_nodes) { EXPECT_TRUE(build({}, 4).nodes.empty()); }

TEST_P(Builder, items_with_one_centre_end_in_one_leaf) {
  const std::vector<Box<float>> items(100, box_at(1, 2, 3));
  const auto tree = build(items, 4);
  EXPECT_EQ(tree.nodes.size(), 1u);
  check(tree, items);
}

TEST_P(Builder, a_cascade_of_ever_smaller_items_stays_within_the_depth_bound) {
  std::vector<Box<float>> items;
  for (int i = 0; i < 3000; ++i) {
    const float at = std::ldexp(1.0f, -(i % 120)) * (1 + static_cast<float>(i) * 1e-4f);
    items.push_back(box_at(at, at * 0.5f, at * 0.25f, 0));
  }
  check(build(items, 1), items);
}

TEST_P(Builder, boxes_so_large_that_areas_overflow_still_keep_the_promises) {
  auto items = scattered(1000);
  for (Box<float>& item : items)
    for (Vec3<float>& corner : item.bounds) corner = corner * 1e37f;
  const auto tree = build(items, 4);
  check(tree, items);
  EXPECT_LE(largest_leaf(tree), 4u);
}

TEST(median, one_leaf_holds_the_scene_when_it_may) {
  const auto tree = build_median<float>(scattered(1000), 1000);
  EXPECT_EQ(tree.nodes.size(), 1u);
}

TEST(median, the_longest_axis_is_halved_in_the_middle_of_the_box) {
  // Nine items near x = 0 and one at x = 10: the middle at x = 5 separates nine from one.
  std::vector<Box<float>> items;
  for (int i = 0; i < 9; ++i) items.push_back(box_at(0.1f * static_cast<float>(i), 0, 0));
  items.push_back(box_at(10, 0, 0));
  const auto tree = build_median<float>(items, 9);
  ASSERT_EQ(tree.nodes.size(), 3u);
  EXPECT_EQ(tree.nodes[1].count, 9u);
  EXPECT_EQ(tree.nodes[2].count, 1u);
}

}  // namespace
}  // namespace raysweep
