#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "tracer/wide/wide_tree.h"

namespace raysweep {

namespace {

// Both read four to seven cache lines and do about fifty vector operations; halving or doubling either
// changes the time of traversal by less than its noise.
constexpr float node_cost = 1, block_cost = 1;
constexpr float never = std::numeric_limits<float>::infinity();

template <int width>
class Collapser {
 public:
  Collapser(const Hierarchy<float>& binary, std::span<const Box<float>> boxes, const CollapseOptions& options)
      : binary_(binary), boxes_(boxes), options_(options), plans_(binary.nodes.size()) {}

  WideTree<width> run() {
    add_block({});  // the sentinel
    tree_.nodes.emplace_back();
    if (binary_.nodes.empty()) {
      std::vector<uint32_t> all(boxes_.size());
      std::iota(all.begin(), all.end(), 0u);
      std::vector<Child> children;
      add_leaves(all, children);
      fill(0, children);
      tree_.depth = 1;
    } else {
      // Children stand behind their parents.
      for (size_t node = binary_.nodes.size(); node-- > 0;) plan(node);
      tree_.cost =
          static_cast<double>(plans_[0].cost[0]) / static_cast<double>(binary_.nodes[0].box.half_area());
      emit_all();
    }
    for (const Box<float>& box : boxes_) tree_.bounds.include(box);
    return std::move(tree_);
  }

 private:
  struct Child {
    WideChild what;
    Box<float> box;
  };

  /// `cost[k − 1]`: of the binary node's subtree as at most k children of one node. `left[k − 1]`: how many
  /// of them its left child gets; 0: it stays one child; −1: k − 1 children are no dearer.
  struct Plan {
    std::array<float, width> cost;
    std::array<int16_t, width> left;
    uint32_t item_count, sphere_count;
    bool is_leaf;
  };

  [[nodiscard]] bool is_sphere(uint32_t item) const { return item < options_.sphere_count; }
  [[nodiscard]] const Node<float>& node(uint32_t i) const { return binary_.nodes[i]; }

  void plan(size_t index) {
    const Node<float>& n = binary_.nodes[index];
    Plan& p = plans_[index];
    p.left.fill(-1);
    if (n.is_leaf()) {
      p.item_count = n.count;
      p.sphere_count = 0;
      for (uint32_t i = n.first; i < n.first + n.count; ++i)
        p.sphere_count += is_sphere(binary_.order[i]) ? 1 : 0;
      const uint32_t blocks = (n.count + width - 1) / width;
      p.cost.fill(n.box.half_area() * block_cost * static_cast<float>(blocks));
      p.left[0] = 0;
      p.is_leaf = true;
      return;
    }
    const Plan &left = plans_[n.first], &right = plans_[n.first + 1];
    p.item_count = left.item_count + right.item_count;
    p.sphere_count = left.sphere_count + right.sphere_count;
    const auto share = [&](int slots) {
      std::pair<float, int16_t> best{never, 1};
      for (int l = 1; l < slots; ++l)
        best = std::min(
            best, {left.cost[static_cast<size_t>(l - 1)] + right.cost[static_cast<size_t>(slots - l - 1)],
                   static_cast<int16_t>(l)});
      return best;
    };
    const bool is_one_kind = p.sphere_count == 0 || p.sphere_count == p.item_count;
    const bool may_be_leaf = options_.merges_leaves && is_one_kind && p.item_count <= width;
    const float as_leaf = may_be_leaf ? n.box.half_area() * block_cost : never;
    const auto [children, first] = share(width);
    const float as_node = children + n.box.half_area() * node_cost;
    p.is_leaf = may_be_leaf && as_leaf <= as_node;  // boxes may be so large that both are infinite
    p.cost[0] = std::min(as_leaf, as_node);
    p.left[0] = first;
    for (int slots = 2; slots < width; ++slots) {
      const auto k = static_cast<size_t>(slots - 1);
      const auto [cost, l] = share(slots);
      const bool pays = cost < p.cost[k - 1];
      p.cost[k] = pays ? cost : p.cost[k - 1];
      p.left[k] = pays ? l : int16_t{-1};
    }
  }

  /// The binary nodes that become the children in `slots` slots of the subtree at `index`.
  void gather(uint32_t index, int slots, std::vector<uint32_t>& chosen) const {
    const Plan& p = plans_[index];
    while (slots > 1 && p.left[static_cast<size_t>(slots - 1)] < 0) --slots;
    if (slots == 1 || node(index).is_leaf()) {
      chosen.push_back(index);
      return;
    }
    const int left = p.left[static_cast<size_t>(slots - 1)];
    gather(node(index).first, left, chosen);
    gather(node(index).first + 1, slots - left, chosen);
  }

  /// All items below, without recursion: forced leaves may lie deep.
  [[nodiscard]] std::vector<uint32_t> items_below(uint32_t index) const {
    std::vector<uint32_t> items, open{index};
    while (!open.empty()) {
      const Node<float>& n = node(open.back());
      open.pop_back();
      if (n.is_leaf()) {
        for (uint32_t i = n.first; i < n.first + n.count; ++i) items.push_back(binary_.order[i]);
      } else {
        open.insert(open.end(), {n.first + 1, n.first});
      }
    }
    return items;
  }

  WideChild add_block(std::span<const uint32_t> items, bool goes_on = false) {
    const size_t index = tree_.block_goes_on.size();
    if (index >= sphere_bit) throw std::length_error("a mesh of more than a billion leaves");
    for (size_t i = 0; i < width; ++i) tree_.block_items.push_back(i < items.size() ? items[i] : no_hit_id);
    tree_.block_goes_on.push_back(goes_on ? 1 : 0);
    return static_cast<WideChild>(index);
  }

  /// One leaf of `items` of one kind.
  WideChild add_leaf(std::span<const uint32_t> items) {
    const WideChild kind = leaf_bit | (is_sphere(items[0]) ? sphere_bit : 0);
    const auto first = static_cast<WideChild>(tree_.block_goes_on.size());
    for (size_t i = 0; i < items.size(); i += width) {
      const size_t count = std::min<size_t>(width, items.size() - i);
      add_block(items.subspan(i, count), i + count < items.size());
    }
    return first | kind;
  }

  /// A leaf of spheres and one of triangles, as far as `items` holds both.
  void add_leaves(std::vector<uint32_t>& items, std::vector<Child>& children) {
    const auto middle =
        std::stable_partition(items.begin(), items.end(), [&](uint32_t i) { return is_sphere(i); });
    for (const std::span<const uint32_t> part :
         {std::span<const uint32_t>(items.begin(), middle), std::span<const uint32_t>(middle, items.end())}) {
      if (part.empty()) continue;
      Box<float> box;
      for (const uint32_t i : part) box.include(boxes_[i]);
      children.push_back({add_leaf(part), box});
    }
  }

  struct Pending {
    uint32_t binary, wide;
    int depth;
  };

  void emit_all() {
    std::vector<Pending> pending{{0, 0, 1}};
    while (!pending.empty()) {
      const Pending now = pending.back();
      pending.pop_back();
      tree_.depth = std::max(tree_.depth, now.depth);
      emit(now, pending);
    }
  }

  void emit(const Pending& now, std::vector<Pending>& pending) {
    std::vector<uint32_t> chosen;
    if (plans_[now.binary].is_leaf) {
      chosen.push_back(now.binary);
    } else {
      const int left = plans_[now.binary].left[0];
      gather(node(now.binary).first, left, chosen);
      gather(node(now.binary).first + 1, width - left, chosen);
    }
    std::vector<Child> children;
    for (size_t i = 0; i < chosen.size(); ++i) {
      const uint32_t below = chosen[i];
      if (!plans_[below].is_leaf || needs_a_node(below, chosen.size() - i - 1 + children.size())) {
        const auto inner = static_cast<uint32_t>(tree_.nodes.size());
        tree_.nodes.emplace_back();
        pending.push_back({below, inner, now.depth + 1});
        children.push_back({inner, node(below).box});
      } else {
        std::vector<uint32_t> items = items_below(below);
        add_leaves(items, children);
      }
    }
    fill(now.wide, children);
  }

  /// A leaf of both kinds takes two slots; where they are not free it gets a node of its own.
  [[nodiscard]] bool needs_a_node(uint32_t leaf, size_t other_slots) const {
    const Plan& p = plans_[leaf];
    return p.sphere_count > 0 && p.sphere_count < p.item_count && other_slots + 2 > width;
  }

  void fill(uint32_t index, const std::vector<Child>& children) {
    WideNode<width>& n = tree_.nodes[index];
    for (size_t i = 0; i < width; ++i) {
      const Box<float> box = i < children.size() ? children[i].box : Box<float>{};
      for (int axis = 0; axis < 3; ++axis) {
        n.bounds[axis][0][i] = box.lower()[axis];
        n.bounds[axis][1][i] = box.upper()[axis];
      }
      n.children[i] = i < children.size() ? children[i].what : leaf_bit;
    }
    for (uint32_t octant = 0; octant < 8; ++octant) n.far_to_near[octant] = order(octant, children);
  }

  /// By the boxes' centres along the octant's diagonal; slots without a child count as farthest.
  static uint32_t order(uint32_t octant, const std::vector<Child>& children) {
    const auto along = [&](size_t i) {
      if (i >= children.size()) return never;
      const Vec3<float> c = children[i].box.centre();
      return ((octant & 1) != 0 ? -c.x : c.x) + ((octant & 2) != 0 ? -c.y : c.y) +
             ((octant & 4) != 0 ? -c.z : c.z);
    };
    std::array<size_t, width> slots;
    std::iota(slots.begin(), slots.end(), size_t{0});
    std::ranges::stable_sort(slots, [&](size_t a, size_t b) { return along(a) > along(b); });
    uint32_t packed = 0;
    for (size_t i = 0; i < width; ++i)
      packed |= static_cast<uint32_t>(slots[i] << (i * WideNode<width>::order_bits));
    return packed;
  }

  const Hierarchy<float>& binary_;
  std::span<const Box<float>> boxes_;
  const CollapseOptions options_;
  std::vector<Plan> plans_;
  WideTree<width> tree_;
};

}  // namespace

template <int width>
WideTree<width> collapse(const Hierarchy<float>& hierarchy, std::span<const Box<float>> boxes,
                         const CollapseOptions& options) {
  return Collapser<width>(hierarchy, boxes, options).run();
}

template WideTree<4> collapse(const Hierarchy<float>&, std::span<const Box<float>>, const CollapseOptions&);
template WideTree<8> collapse(const Hierarchy<float>&, std::span<const Box<float>>, const CollapseOptions&);

}  // namespace raysweep
