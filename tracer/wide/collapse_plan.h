// Which nodes of a binary hierarchy become children of wide nodes: Ylitie, Karras & Laine 2017, "Efficient
// incoherent ray traversal on GPUs through compressed wide BVHs", section 3.1.
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "tracer/for_each.h"
#include "tracer/wide/wide_tree.h"

namespace raysweep {

/// As how many subtrees a hierarchy is shared: what is above them nobody shares, so a small one makes few.
[[nodiscard]] inline size_t shared_subtrees(const Hierarchy<float>& binary) {
  return std::clamp<size_t>(binary.nodes.size() / 256, 8, 64);
}

/// The cheapest ways to make each binary node's subtree into children of one wide node.
template <int width>
class CollapsePlan {
 public:
  CollapsePlan(const Hierarchy<float>& binary, const CollapseOptions& options, const ForEach& for_each)
      : binary_(binary), options_(options), plans_(binary.nodes.size()) {
    // Subtrees share the work; what is above them is planned last, from below.
    const size_t enough_subtrees = 2 * shared_subtrees(binary);
    std::vector<uint32_t> open{0}, above;
    size_t next = 0;
    for (; next < open.size() && open.size() - next < enough_subtrees; ++next) {
      const Node<float>& n = binary.nodes[open[next]];
      above.push_back(open[next]);
      if (!n.is_leaf()) open.insert(open.end(), {n.first, n.first + 1});
    }
    for_each(open.size() - next, [&](size_t i) { plan_all_below(open[next + i]); });
    for (size_t i = above.size(); i-- > 0;) plan(above[i]);
  }

  [[nodiscard]] bool is_leaf(uint32_t node) const { return plans_[node].is_leaf; }
  [[nodiscard]] bool is_one_kind(uint32_t node) const { return plans_[node].is_one_kind(); }
  [[nodiscard]] double cost() const { return static_cast<double>(plans_[0].cost[0]); }

  /// Binary nodes that become the children of one node.
  struct Chosen {
    std::array<uint32_t, width> at;
    size_t count = 0;
  };
  /// Of the wide node that stands for `node`, which may be a leaf only where it is the root.
  [[nodiscard]] Chosen children(uint32_t node) const {
    Chosen chosen;
    if (plans_[node].is_leaf) {
      chosen.at[chosen.count++] = node;
    } else {
      const int left = plans_[node].left[0];
      gather(binary_.nodes[node].first, left, chosen);
      gather(binary_.nodes[node].first + 1, width - left, chosen);
    }
    return chosen;
  }

 private:
  // Both read four to seven cache lines and do about fifty vector operations; halving or doubling either
  // changes the time of traversal by less than its noise.
  static constexpr float node_cost = 1, block_cost = 1;
  static constexpr float never = std::numeric_limits<float>::infinity();

  /// `cost[k − 1]`: of the binary node's subtree as at most k children of one node. `left[k − 1]`: how many
  /// of them its left child gets; −1: k − 1 children are no dearer. `left[0]`: how many of `width` it gets
  /// where this one child is a wide node; 0 for a leaf. More than `most` there cannot be.
  struct Plan {
    std::array<float, width> cost;
    std::array<int16_t, width> left;
    uint32_t item_count, sphere_count;
    int16_t most;
    bool is_leaf;
    [[nodiscard]] bool is_one_kind() const { return sphere_count == 0 || sphere_count == item_count; }
  };

  /// The recursion is no deeper than any hierarchy.
  void plan_all_below(uint32_t index) {
    const Node<float>& n = binary_.nodes[index];
    if (!n.is_leaf()) {
      plan_all_below(n.first);
      plan_all_below(n.first + 1);
    }
    plan(index);
  }

  void plan(uint32_t index) { binary_.nodes[index].is_leaf() ? plan_leaf(index) : plan_inner(index); }

  void plan_leaf(uint32_t index) {
    const Node<float>& n = binary_.nodes[index];
    Plan& p = plans_[index];
    p.item_count = n.count;
    p.sphere_count = 0;
    for (uint32_t i = n.first; i < n.first + n.count; ++i)
      p.sphere_count += binary_.order[i] < options_.sphere_count ? 1 : 0;
    const uint32_t blocks = (n.count + width - 1) / width;
    p.cost.fill(n.box.half_area() * block_cost * static_cast<float>(blocks));
    p.left.fill(-1);
    p.left[0] = 0;
    p.most = 1;
    p.is_leaf = true;
  }

  struct Share {
    float cost;
    int16_t left;
  };
  /// The cheapest way to share `slots` among two subtrees, of those that leave no slot empty.
  static Share share(const Plan& left, const Plan& right, int slots) {
    Share best{never, static_cast<int16_t>(std::max(1, slots - right.most))};
    for (int l = best.left; l < slots && l <= left.most; ++l) {
      const float cost =
          left.cost[static_cast<size_t>(l - 1)] + right.cost[static_cast<size_t>(slots - l - 1)];
      if (cost < best.cost) best = {cost, static_cast<int16_t>(l)};
    }
    return best;
  }

  void plan_inner(uint32_t index) {
    const Node<float>& n = binary_.nodes[index];
    Plan& p = plans_[index];
    const Plan &left = plans_[n.first], &right = plans_[n.first + 1];
    p.item_count = left.item_count + right.item_count;
    p.sphere_count = left.sphere_count + right.sphere_count;
    p.most = static_cast<int16_t>(std::min(width, left.most + right.most));
    const float area = n.box.half_area();
    const bool may_be_leaf = options_.merges_leaves && p.is_one_kind() && p.item_count <= width;
    const float as_leaf = may_be_leaf ? area * block_cost : never;
    const Share of_node = share(left, right, p.most);
    const float as_node = of_node.cost + area * node_cost;
    p.is_leaf = may_be_leaf && as_leaf <= as_node;  // boxes may be so large that both are infinite
    p.cost[0] = std::min(as_leaf, as_node);
    p.left[0] = of_node.left;
    for (int slots = 2; slots < width; ++slots) {
      const auto k = static_cast<size_t>(slots - 1);
      const Share s = slots < p.most    ? share(left, right, slots)
                      : slots == p.most ? of_node
                                        : Share{never, -1};
      const bool pays = s.cost < p.cost[k - 1];
      p.cost[k] = pays ? s.cost : p.cost[k - 1];
      p.left[k] = pays ? s.left : int16_t{-1};
    }
  }

  /// The binary nodes that become the children in `slots` slots of the subtree at `index`.
  void gather(uint32_t index, int slots, Chosen& chosen) const {
    const Plan& p = plans_[index];
    while (slots > 1 && p.left[static_cast<size_t>(slots - 1)] < 0) --slots;
    if (slots == 1 || binary_.nodes[index].is_leaf()) {
      chosen.at[chosen.count++] = index;
      return;
    }
    const int left = p.left[static_cast<size_t>(slots - 1)];
    gather(binary_.nodes[index].first, left, chosen);
    gather(binary_.nodes[index].first + 1, slots - left, chosen);
  }

  const Hierarchy<float>& binary_;
  const CollapseOptions options_;
  UnsetVector<Plan> plans_;
};

}  // namespace raysweep
