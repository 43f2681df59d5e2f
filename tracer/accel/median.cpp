#include <algorithm>
#include <numeric>

#include "tracer/accel/hierarchy.h"

namespace raysweep {

namespace {

/// A node about to be split: its items, the box around them, and the box around their centres.
template <class T>
struct SplitRequest {
  std::span<const Box<T>> items;
  std::span<uint32_t> order;  // the node's part
  Box<T> box, centres;
  int leaf_size;
};

/// Reorders `order` so that items with centre < `position` on `axis` come first; how many those are.
template <class T>
size_t partition_at(const SplitRequest<T>& node, int axis, T position) {
  const auto middle = std::partition(node.order.begin(), node.order.end(),
                                     [&](uint32_t i) { return node.items[i].centre()[axis] < position; });
  return static_cast<size_t>(middle - node.order.begin());
}

/// Halves the count of items along the longest axis of the centres.
template <class T>
size_t partition_evenly(const SplitRequest<T>& node) {
  const int axis = node.centres.longest_axis();
  const size_t half = node.order.size() / 2;
  std::nth_element(
      node.order.begin(), node.order.begin() + static_cast<std::ptrdiff_t>(half), node.order.end(),
      [&](uint32_t a, uint32_t b) { return node.items[a].centre()[axis] < node.items[b].centre()[axis]; });
  return half;
}

/// Partitions the request's `order`; the size of its first part, or 0 for a leaf. Asked only where the
/// centres differ, and not below `balanced_from_depth`.
template <class T>
size_t split_in_the_middle(const SplitRequest<T>& node) {
  if (node.order.size() <= static_cast<size_t>(node.leaf_size)) return 0;
  for (const Box<T>* halved : {&node.box, &node.centres}) {
    const int axis = halved->longest_axis();
    const size_t left = partition_at(node, axis, halved->centre()[axis]);
    if (left > 0 && left < node.order.size()) return left;
  }
  // The centres differ by so little that their middle rounds to the lower one.
  return partition_evenly(node);
}

}  // namespace

template <class T>
Hierarchy<T> build_median(std::span<const Box<T>> items, int leaf_size) {
  Hierarchy<T> tree;
  if (items.empty()) return tree;
  tree.order.resize(items.size());
  std::iota(tree.order.begin(), tree.order.end(), 0u);
  struct Pending {
    uint32_t node, begin, end;
    int depth;
  };
  std::vector<Pending> pending{{0, 0, static_cast<uint32_t>(items.size()), 0}};
  tree.nodes.emplace_back();
  while (!pending.empty()) {
    const Pending p = pending.back();
    pending.pop_back();
    SplitRequest<T> request{
        items, std::span(tree.order).subspan(p.begin, p.end - p.begin), {}, {}, leaf_size};
    for (const uint32_t i : request.order) {
      request.box.include(items[i]);
      request.centres.include(items[i].centre());
    }
    size_t left = 0;
    if (request.centres.lower() != request.centres.upper()) {
      if (p.depth < balanced_from_depth) {
        left = split_in_the_middle(request);
      } else if (request.order.size() > static_cast<size_t>(leaf_size)) {
        left = partition_evenly(request);
      }
    }
    Node<T>& node = tree.nodes[p.node];
    node.box = request.box;
    if (left == 0) {
      node.first = p.begin;
      node.count = p.end - p.begin;
      continue;
    }
    const auto first = static_cast<uint32_t>(tree.nodes.size());
    node.first = first;
    node.count = 0;
    const auto middle = p.begin + static_cast<uint32_t>(left);
    pending.push_back({first + 1, middle, p.end, p.depth + 1});
    pending.push_back({first, p.begin, middle, p.depth + 1});
    tree.nodes.resize(tree.nodes.size() + 2);
  }
  return tree;
}

template Hierarchy<float> build_median(std::span<const Box<float>>, int);
template Hierarchy<double> build_median(std::span<const Box<double>>, int);

}  // namespace raysweep
