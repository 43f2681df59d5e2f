#include <array>

#include "tracer/accel/build.h"

namespace raysweep {

namespace {

constexpr int bin_count = 16;
// Cost of visiting a node, in triangle tests: both read one cache line and do about twenty operations.
constexpr double node_cost = 1;

template <class T>
struct Bin {
  Box<T> box;
  size_t count = 0;
};

template <class T>
struct Plan {
  double cost = std::numeric_limits<double>::infinity();
  int axis = 0;
  T position = 0;  // first centre that goes right
};

/// The cheapest of the `bin_count − 1` planes on one axis; cost as the sum of area × count on both sides.
template <class T>
Plan<T> plan_axis(const SplitRequest<T>& node, int axis) {
  const T low = node.centres.lower()[axis], width = (node.centres.upper()[axis] - low) / bin_count;
  Plan<T> best;
  if (!(width > 0)) return best;
  std::array<Bin<T>, bin_count> bins;
  for (const uint32_t i : node.order) {
    // Counted by comparison with the very positions that partition_at will compare with: no item changes
    // sides.
    const T centre = node.items[i].centre()[axis];
    int b = std::clamp(static_cast<int>((centre - low) / width), 0, bin_count - 1);
    while (b > 0 && centre < low + static_cast<T>(b) * width) --b;
    while (b < bin_count - 1 && centre >= low + static_cast<T>(b + 1) * width) ++b;
    bins[static_cast<size_t>(b)].box.include(node.items[i]);
    bins[static_cast<size_t>(b)].count++;
  }
  std::array<double, bin_count> right_cost{};
  Bin<T> right;
  for (size_t b = bin_count - 1; b > 0; --b) {
    right.box.include(bins[b].box);
    right.count += bins[b].count;
    right_cost[b] = static_cast<double>(right.box.half_area()) * static_cast<double>(right.count);
  }
  Bin<T> left;
  for (size_t b = 1; b < bin_count; ++b) {
    left.box.include(bins[b - 1].box);
    left.count += bins[b - 1].count;
    if (left.count == 0 || left.count == node.order.size()) continue;
    const double cost =
        static_cast<double>(left.box.half_area()) * static_cast<double>(left.count) + right_cost[b];
    if (cost < best.cost) best = {cost, axis, low + static_cast<T>(b) * width};
  }
  return best;
}

template <class T>
size_t split_by_area(const SplitRequest<T>& node) {
  Plan<T> best;
  for (int axis = 0; axis < 3; ++axis) {
    const Plan<T> plan = plan_axis(node, axis);
    if (plan.cost < best.cost) best = plan;
  }
  const bool may_be_leaf = node.order.size() <= static_cast<size_t>(node.leaf_size);
  const double area = static_cast<double>(node.box.half_area());
  if (may_be_leaf && !(best.cost + node_cost * area < area * static_cast<double>(node.order.size())))
    return 0;
  if (!(best.cost < std::numeric_limits<double>::infinity())) return partition_evenly(node);
  return partition_at(node, best.axis, best.position);
}

}  // namespace

template <class T>
Hierarchy<T> build_sah(std::span<const Box<T>> items, int leaf_size) {
  return build_hierarchy(items, leaf_size, split_by_area<T>);
}

template Hierarchy<float> build_sah(std::span<const Box<float>>, int);
template Hierarchy<double> build_sah(std::span<const Box<double>>, int);

}  // namespace raysweep
