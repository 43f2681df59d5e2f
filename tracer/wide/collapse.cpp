#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "tracer/wide/collapse_plan.h"
#include "tracer/wide/node_of_children.h"

namespace raysweep {

namespace {

/// A binary node that becomes wide node `wide`.
struct Pending {
  uint32_t binary, wide;
  int depth;
};

/// What items are and where.
struct Items {
  std::span<const Box<float>> boxes;
  uint32_t sphere_count;
  [[nodiscard]] bool is_sphere(uint32_t item) const { return item < sphere_count; }
};

/// Makes nodes and blocks of a part of the tree, numbered from 0; block 0 is the sentinel.
template <int width>
class Emitter {
 public:
  WideTree<width> tree;

  Emitter(const Hierarchy<float>& binary, const CollapsePlan<width>& plan, const Items& items)
      : binary_(binary), plan_(plan), items_(items) {
    add_block({});
  }

  /// Fills `now.wide`. Children that are wide nodes themselves are made room for and added to `pending`.
  void emit(const Pending& now, std::vector<Pending>& pending) {
    tree.depth = std::max(tree.depth, now.depth);
    const auto chosen = plan_.children(now.binary);
    Children<width> children;
    for (size_t i = 0; i < chosen.count; ++i) {
      const uint32_t below = chosen.at[i];
      // A leaf of both kinds takes two slots; where they are not free it gets a node of its own.
      const bool fits = plan_.is_one_kind(below) || children.count + chosen.count - i < width;
      if (plan_.is_leaf(below) && fits) {
        add_leaves_below(below, children);
      } else {
        const auto inner = static_cast<uint32_t>(tree.nodes.size());
        tree.nodes.emplace_back();
        pending.push_back({below, inner, now.depth + 1});
        children.add(inner, binary_.nodes[below].box);
      }
    }
    children.put_large_ones_first(binary_.nodes[now.binary].box);
    tree.nodes[now.wide] = node_of(children);
  }

  /// `emit` for `root` and all below it.
  void emit_all(const Pending& root) {
    tree.nodes.emplace_back();
    std::vector<Pending> pending{{root.binary, 0, root.depth}};
    while (!pending.empty()) {
      const Pending now = pending.back();
      pending.pop_back();
      emit(now, pending);
    }
  }

 private:
  /// A leaf of spheres and one of triangles, as far as `all`, what a node's box `around` is of, holds both.
  void add_leaves(std::span<uint32_t> all, const Box<float>& around, Children<width>& children) {
    const auto middle =
        std::stable_partition(all.begin(), all.end(), [&](uint32_t i) { return items_.is_sphere(i); });
    for (const std::span<const uint32_t> part :
         {std::span<const uint32_t>(all.begin(), middle), std::span<const uint32_t>(middle, all.end())}) {
      if (part.empty()) continue;
      Box<float> box;
      for (const uint32_t i : part) box.include(items_.boxes[i]);
      box.bounds[0] = max(box.lower(), around.lower());
      box.bounds[1] = min(box.upper(), around.upper());
      children.add(add_leaf(part), box);
    }
  }

  void add_leaves_below(uint32_t index, Children<width>& children) {
    gather_items(index);
    if (plan_.is_one_kind(index)) {
      children.add(add_leaf(found_), binary_.nodes[index].box);
    } else {
      add_leaves(found_, binary_.nodes[index].box, children);
    }
  }

  /// One leaf of `items` of one kind.
  WideChild add_leaf(std::span<const uint32_t> items) {
    const WideChild kind = leaf_bit | (items_.is_sphere(items[0]) ? sphere_bit : 0);
    const auto first = static_cast<WideChild>(tree.block_goes_on.size());
    for (size_t i = 0; i < items.size(); i += width) {
      const size_t count = std::min<size_t>(width, items.size() - i);
      add_block(items.subspan(i, count), i + count < items.size());
    }
    return first | kind;
  }

  void add_block(std::span<const uint32_t> items, bool goes_on = false) {
    for (size_t i = 0; i < width; ++i) tree.block_items.push_back(i < items.size() ? items[i] : no_hit_id);
    tree.block_goes_on.push_back(goes_on ? 1 : 0);
  }

  /// All items below, each once, without recursion: forced leaves may lie deep.
  void gather_items(uint32_t index) {
    found_.clear();
    open_.assign(1, index);
    while (!open_.empty()) {
      const Node<float>& n = binary_.nodes[open_.back()];
      open_.pop_back();
      if (n.is_leaf()) {
        const auto others = static_cast<std::ptrdiff_t>(found_.size());
        for (uint32_t i = n.first; i < n.first + n.count; ++i) {
          const auto end = found_.begin() + others;
          if (std::find(found_.begin(), end, binary_.order[i]) == end) found_.push_back(binary_.order[i]);
        }
      } else {
        open_.insert(open_.end(), {n.first + 1, n.first});
      }
    }
  }

  const Hierarchy<float>& binary_;
  const CollapsePlan<width>& plan_;
  Items items_;
  std::vector<uint32_t> found_, open_;
};

/// Where a part of the tree that was made apart belongs: its first node to `root`, the others to `first_node`
/// and behind, its blocks but the sentinel to `first_block` and behind.
struct Place {
  size_t root, first_node, first_block;
};

template <int width>
void move_in(const WideTree<width>& part, const Place& to, WideTree<width>& tree) {
  for (size_t i = 0; i < part.nodes.size(); ++i) {
    WideNode<width>& n = tree.nodes[i == 0 ? to.root : to.first_node + i - 1];
    n = part.nodes[i];
    for (WideChild& child : n.children) {
      if (child == leaf_bit) continue;  // the sentinel: there is no child
      child += static_cast<WideChild>((child & leaf_bit) != 0 ? to.first_block - 1 : to.first_node - 1);
    }
  }
  const auto block = static_cast<std::ptrdiff_t>(to.first_block);
  std::copy(part.block_items.begin() + width, part.block_items.end(),
            tree.block_items.begin() + block * width);
  std::copy(part.block_goes_on.begin() + 1, part.block_goes_on.end(), tree.block_goes_on.begin() + block);
}

template <int width>
class Collapser {
 public:
  Collapser(const Hierarchy<float>& binary, const Items& items, const CollapseOptions& options,
            const ForEach& for_each)
      : binary_(binary), items_(items), for_each_(for_each), plan_(binary, options, for_each) {}

  WideTree<width> run() {
    // Subtrees share the work.
    const size_t enough_subtrees = shared_subtrees(binary_);
    Emitter<width> top(binary_, plan_, items_);
    top.tree.nodes.emplace_back();
    std::vector<Pending> open{{0, 0, 1}};
    size_t next = 0;
    for (; next < open.size() && open.size() - next < enough_subtrees; ++next) {
      const Pending now = open[next];
      top.emit(now, open);
    }
    const std::span<const Pending> roots = std::span(open).subspan(next);
    std::vector<Emitter<width>> parts(roots.size(), Emitter<width>(binary_, plan_, items_));
    for_each_(parts.size(), [&](size_t i) { parts[i].emit_all(roots[i]); });
    WideTree<width> tree = join(std::move(top.tree), roots, parts);
    tree.cost = plan_.cost() / static_cast<double>(binary_.nodes[0].box.half_area());
    tree.bounds = widened(binary_.nodes[0].box);
    tree.is_cut = binary_.order.size() > items_.boxes.size();
    return tree;
  }

 private:
  [[nodiscard]] WideTree<width> join(WideTree<width> tree, std::span<const Pending> roots,
                                     const std::vector<Emitter<width>>& parts) const {
    std::vector<Place> places;
    size_t node_count = tree.nodes.size(), block_count = tree.block_goes_on.size();
    for (size_t i = 0; i < parts.size(); ++i) {
      places.push_back({roots[i].wide, node_count, block_count});
      tree.depth = std::max(tree.depth, parts[i].tree.depth);
      node_count += parts[i].tree.nodes.size() - 1;
      block_count += parts[i].tree.block_goes_on.size() - 1;
    }
    // Packets number children of nodes below `leaf_bit`.
    if (block_count >= sphere_bit || node_count >= leaf_bit / width)
      throw std::length_error("a mesh of more than a billion leaves");
    tree.nodes.resize(node_count);
    tree.block_items.resize(block_count * width);
    tree.block_goes_on.resize(block_count);
    for_each_(parts.size(), [&](size_t i) { move_in(parts[i].tree, places[i], tree); });
    return tree;
  }

  const Hierarchy<float>& binary_;
  Items items_;
  const ForEach& for_each_;
  CollapsePlan<width> plan_;
};

Hierarchy<float> one_leaf(std::span<const Box<float>> boxes) {
  Hierarchy<float> leaf{{Node<float>{}}, UnsetVector<uint32_t>(boxes.size())};
  std::iota(leaf.order.begin(), leaf.order.end(), 0u);
  for (const Box<float>& box : boxes) leaf.nodes[0].box.include(box);
  leaf.nodes[0].count = static_cast<uint32_t>(boxes.size());
  return leaf;
}

/// A root without children.
template <int width>
WideTree<width> nothing() {
  WideTree<width> tree;
  tree.nodes.push_back(node_of(Children<width>{}));
  tree.block_items.assign(width, no_hit_id);  // the sentinel's
  tree.block_goes_on.assign(1, 0);
  tree.depth = 1;
  return tree;
}

}  // namespace

template <int width>
WideTree<width> collapse(const Hierarchy<float>& hierarchy, std::span<const Box<float>> boxes,
                         const CollapseOptions& options, const ForEach& for_each) {
  if (boxes.empty()) return nothing<width>();
  const Items items{boxes, options.sphere_count};
  if (hierarchy.nodes.empty()) return Collapser<width>(one_leaf(boxes), items, options, for_each).run();
  return Collapser<width>(hierarchy, items, options, for_each).run();
}

template WideTree<4> collapse(const Hierarchy<float>&, std::span<const Box<float>>, const CollapseOptions&,
                              const ForEach&);
template WideTree<8> collapse(const Hierarchy<float>&, std::span<const Box<float>>, const CollapseOptions&,
                              const ForEach&);

}  // namespace raysweep
