// Hierarchies that cut boxes in two: what they promise, and what that saves.
#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "tests/tracer/hierarchy_cost.h"
#include "tests/tracer/shared_work.h"
#include "tests/tracer/sticks.h"
#include "tracer/accel/primitives.h"
#include "tracer/intersect/moller_trumbore.h"
#include "tracer/scene/scenes.h"

namespace raysweep {
namespace {

std::vector<Box<float>> boxes_of(const Scene& scene) {
  const Primitives<float, MollerTrumbore> primitives(scene);
  const UnsetVector<Box<float>> boxes = primitives.boxes();
  return {boxes.begin(), boxes.end()};
}

float& part_of(Vec3f& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

/// Items that a leaf holds which `t` leads to: every box on the way has it.
std::set<uint32_t> items_at(const Hierarchy<float>& tree, const SlabRay<float>& ray, float t) {
  std::set<uint32_t> found;
  const std::function<void(uint32_t)> visit = [&](uint32_t index) {
    const Node<float>& node = tree.nodes[index];
    const Interval<float> inside = slab(node.box, ray);
    if (!(inside.enter <= t && t <= inside.leave)) return;
    if (node.is_leaf()) {
      found.insert(tree.order.begin() + node.first, tree.order.begin() + node.first + node.count);
    } else {
      visit(node.first);
      visit(node.first + 1);
    }
  };
  visit(0);
  return found;
}

/// Where `ray` meets the planes of a box, and the next numbers on both sides.
std::vector<float> beside_planes(const Box<float>& box, const SlabRay<float>& ray) {
  constexpr float inf = Box<float>::inf;
  std::vector<float> result;
  for (const Vec3f& corner : box.bounds) {
    for (int axis = 0; axis < 3; ++axis) {
      const float t = (corner[axis] - ray.origin[axis]) * ray.reciprocal[axis];
      for (const float at : {t, std::nextafter(t, -inf), std::nextafter(t, inf)}) result.push_back(at);
    }
  }
  return result;
}

/// A ray through `box` from near or far, every third one along a coordinate plane.
Ray<float> ray_through(const Box<float>& box, std::mt19937& random) {
  std::uniform_real_distribution<float> uniform(0, 1);
  const auto anywhere = [&] {
    const float x = uniform(random), y = uniform(random), z = uniform(random);
    return Vec3f(x, y, z);
  };
  const Vec3f share = anywhere(), size = box.size(),
              at = box.lower() + Vec3f(size.x * share.x, size.y * share.y, size.z * share.z);
  Vec3f direction = anywhere() - Vec3f(0.5f, 0.5f, 0.5f);
  if (random() % 3 == 0)
    part_of(direction, static_cast<int>(random() % 3)) = random() % 2 == 0 ? 0.0f : -0.0f;
  return {at - direction * std::ldexp(1.0f, static_cast<int>(random() % 30)), direction};
}

/// What `accept` may ask for: any place inside an item's box, at its ends and next to where it is cut.
TEST(sbvh, wherever_a_ray_is_inside_an_items_box_boxes_lead_to_the_item) {
  const auto items = boxes_of(sticks(600, 100));
  const auto tree = build_sbvh<float>(items, {.whole_count = 3}, 2);
  ASSERT_GT(tree.order.size(), items.size());
  std::mt19937 random(1);
  int missed = 0, asked = 0;
  for (const Node<float>& leaf : tree.nodes) {
    for (uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
      const uint32_t item = tree.order[i];
      for (int k = 0; k < 20; ++k) {
        Ray<float> ray = ray_through(items[item], random);
        // In the plane of a cut, where it meets that plane nowhere or everywhere.
        if (const int axis = static_cast<int>(random() % 6); axis < 3)
          part_of(ray.origin, axis) = leaf.box.upper()[axis];
        const SlabRay<float> slab_ray(ray);
        const Interval<float> inside = slab(items[item], slab_ray);
        if (inside.empty()) continue;
        auto places = beside_planes(leaf.box, slab_ray);
        places.insert(places.end(), {inside.enter, inside.leave});
        for (const float t : places) {
          if (!(inside.enter <= t && t <= inside.leave)) continue;
          asked++;
          missed += items_at(tree, slab_ray, t).contains(item) ? 0 : 1;
        }
      }
    }
  }
  EXPECT_EQ(missed, 0);
  EXPECT_GT(asked, 50'000);
}

TEST(sbvh, thin_triangles_cost_less) {
  const auto items = boxes_of(sticks(3000, 0));
  EXPECT_LT(cost(build_sbvh<float>(items, {}, 4)), 0.85 * cost(build_sah<float>(items, 4)));
}

/// The walls of the room are parted from the rock before they are from each other.
TEST(sbvh, large_triangles_that_planes_part_from_small_ones_are_not_cut_in_vain) {
  const auto items = boxes_of(load_scene("grotto"));
  EXPECT_LT(cost(build_sbvh<float>(items, {}, 4)), 1.01 * cost(build_sah<float>(items, 4)));
}

TEST(sbvh, references_are_as_many_as_allowed_at_most) {
  const auto items = boxes_of(sticks(3000, 0));
  const auto count_with = [&](double more) {
    return static_cast<double>(build_sbvh<float>(items, {.more = more}, 4).order.size());
  };
  const auto count = static_cast<double>(items.size());
  EXPECT_EQ(count_with(0), count);
  EXPECT_LE(count_with(0.1), 1.1 * count);
  EXPECT_LE(count_with(0.5), 1.5 * count);
  EXPECT_GT(count_with(0.5), 1.2 * count);
}

TEST(sbvh, what_is_to_stay_whole_is_in_one_leaf) {
  const auto items = boxes_of(sticks(3000, 0));
  for (const uint32_t whole : {3u, 100u}) {
    const auto tree = build_sbvh<float>(items, {.whole_count = whole}, 4);
    std::vector<int> times(items.size());
    for (const uint32_t item : tree.order) times[item]++;
    EXPECT_EQ(std::count(times.begin(), times.begin() + whole, 1), whole);
    EXPECT_GT(std::ranges::count_if(times, [](int n) { return n > 1; }), 500);
  }
}

TEST(sbvh, the_tree_is_the_same_whoever_shares_the_work) {
  const auto items = boxes_of(sticks(20'000, 1000));  // several subtrees
  const auto tree = build_sbvh<float>(items, {.whole_count = 3}, 4);
  for (const ForEach& for_each : {ForEach(backwards), ForEach(by_threads)}) {
    const auto other = build_sbvh<float>(items, {.whole_count = 3}, 4, 1, for_each);
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

}  // namespace
}  // namespace raysweep
