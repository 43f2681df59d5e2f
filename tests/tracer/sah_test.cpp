// What trees by the surface area heuristic cost.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/tracer/hierarchy_cost.h"
#include "tests/tracer/scattered_boxes.h"
#include "tests/tracer/shared_work.h"
#include "tracer/accel/primitives.h"
#include "tracer/intersect/moller_trumbore.h"
#include "tracer/scene/scenes.h"

namespace raysweep {
namespace {

/// What a tree costs, × the root's area, that splits between whatever two items is cheapest.
class FullSweep {
 public:
  FullSweep(std::span<const Box<float>> items, size_t leaf_size) : items_(items), leaf_size_(leaf_size) {}

  [[nodiscard]] double cost(std::vector<uint32_t> order) const {
    const double area = area_of(order), as_leaf = area * static_cast<double>(order.size());
    double best = std::numeric_limits<double>::infinity();
    std::vector<uint32_t> left, right;
    for (int axis = 0; axis < 3; ++axis) {
      std::ranges::sort(order, {}, [&](uint32_t i) { return items_[i].centre()[axis]; });
      const auto from_left = areas(order);
      std::ranges::reverse(order);
      const auto from_right = areas(order);
      std::ranges::reverse(order);
      for (size_t n = 1; n < order.size(); ++n) {
        const size_t m = order.size() - n;
        const double here = from_left[n] * static_cast<double>(n) + from_right[m] * static_cast<double>(m);
        if (!(here < best)) continue;
        best = here;
        left.assign(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(n));
        right.assign(order.begin() + static_cast<std::ptrdiff_t>(n), order.end());
      }
    }
    if (order.size() == 1 || (order.size() <= leaf_size_ && as_leaf <= best + area)) return as_leaf;
    return area + cost(left) + cost(right);
  }

 private:
  /// Of the first 0, 1, … of `order`.
  [[nodiscard]] std::vector<double> areas(const std::vector<uint32_t>& order) const {
    std::vector<double> result{0};
    Box<float> box;
    for (const uint32_t i : order) {
      box.include(items_[i]);
      result.push_back(static_cast<double>(box.half_area()));
    }
    return result;
  }
  [[nodiscard]] double area_of(const std::vector<uint32_t>& order) const { return areas(order).back(); }

  std::span<const Box<float>> items_;
  size_t leaf_size_;
};

void expect_cost_of_a_full_sweep(std::span<const Box<float>> items) {
  std::vector<uint32_t> all(items.size());
  std::iota(all.begin(), all.end(), 0u);
  Box<float> root;
  for (const Box<float>& item : items) root.include(item);
  const double sweep = FullSweep(items, 4).cost(all) / static_cast<double>(root.half_area());
  EXPECT_LT(cost(build_sah<float>(items, 4)), 1.03 * sweep);
}

/// Either may be cheaper, as both look one split ahead only.
TEST(sah, bins_cost_as_little_as_a_full_sweep) {
  expect_cost_of_a_full_sweep(scattered(3000));
  for (const char* scene : {"chair-ball", "studio"}) {
    const Primitives<float, MollerTrumbore> primitives(load_scene(scene));
    SCOPED_TRACE(scene);
    expect_cost_of_a_full_sweep(primitives.boxes());
  }
}

TEST(sah, the_tree_is_the_same_whoever_shares_the_work) {
  const auto items = scattered(40'000);  // several chunks and subtrees
  const auto tree = build_sah<float>(items, 4);
  for (const ForEach& for_each : {ForEach(backwards), ForEach(by_threads)}) {
    const auto other = build_sah<float>(items, 4, 1, for_each);
    EXPECT_EQ(other.order, tree.order);
    ASSERT_EQ(other.nodes.size(), tree.nodes.size());
    for (size_t i = 0; i < tree.nodes.size(); ++i) {
      EXPECT_EQ(other.nodes[i].first, tree.nodes[i].first);
      EXPECT_EQ(other.nodes[i].count, tree.nodes[i].count);
      EXPECT_EQ(other.nodes[i].box.lower(), tree.nodes[i].box.lower());
      EXPECT_EQ(other.nodes[i].box.upper(), tree.nodes[i].box.upper());
    }
  }
}

TEST(sah, splits_a_leaf_that_may_stay_whole_where_that_is_cheaper) {
  // Two far clusters: one node of 8 costs 8 tests, two of 4 cost about 4.
  std::vector<Box<float>> items;
  for (int i = 0; i < 4; ++i) {
    items.push_back(box_at(0.02f * static_cast<float>(i), 0, 0));
    items.push_back(box_at(100 + 0.02f * static_cast<float>(i), 0, 0));
  }
  EXPECT_LE(largest_leaf(build_sah<float>(items, 8)), 4u);
  EXPECT_EQ(build_sah<float>(items, 8, 8).nodes.size(), 1u) << "tested at once they cost one test";
}

}  // namespace
}  // namespace raysweep
