#include "tracer/accel/cutting_parts.h"

namespace raysweep {

namespace {

/// A subtree's nodes and what its leaves hold, both numbered from 0.
template <class T>
struct Subtree {
  UnsetVector<Node<T>> nodes;
  UnsetVector<uint32_t> order;
};

template <class T>
class CuttingBuilder {
 public:
  CuttingBuilder(std::span<const Box<T>> items, const CutOptions& options, int leaf_size, int block,
                 const ForEach& for_each)
      : items_(items),
        for_each_(for_each),
        most_(items.size() + static_cast<size_t>(static_cast<double>(items.size()) * options.more)),
        parts_(most_, leaf_size, block, options.whole_count) {
    tree_.nodes.emplace_back();
  }

  [[nodiscard]] Hierarchy<T> run() {
    constexpr uint32_t small = 4096, enough_subtrees = 64;
    const auto subtree_size = std::max(small, static_cast<uint32_t>(items_.size() / enough_subtrees));
    std::vector<Part<T>> level{root()};
    while (!level.empty()) {
      const auto middle = std::stable_partition(
          level.begin(), level.end(), [&](const Part<T>& part) { return part.count() > subtree_size; });
      roots_.insert(roots_.end(), middle, level.end());
      level.erase(middle, level.end());
      level = split_all(level);
    }
    build_subtrees();
    return std::move(tree_);
  }

 private:
  struct Halves {
    Part<T> left, right;
    bool is_leaf;
  };

  [[nodiscard]] Part<T> root() {
    const auto count = static_cast<uint32_t>(items_.size());
    Part<T> root = Part<T>::of(0, count, 0, 0);
    root.room = static_cast<uint32_t>(most_) - count;
    const std::span<Reference<T>> references = parts_.references(root);
    for (uint32_t i = 0; i < count; ++i) {
      references[i].set(items_[i], i);
      root.box.include(references[i].lower, references[i].upper);
    }
    root.centres = bounds_of_centres<T>(references);
    parts_.set_bounds(root.box.box());
    return root;
  }

  /// The parts of the next level. What is a leaf already is a subtree.
  [[nodiscard]] std::vector<Part<T>> split_all(const std::vector<Part<T>>& level) {
    std::vector<Halves> halves(level.size());
    for_each_(level.size(), [&](size_t i) {
      halves[i].is_leaf = !parts_.split(level[i], halves[i].left, halves[i].right);
    });
    std::vector<Part<T>> next;
    for (size_t i = 0; i < level.size(); ++i) {
      if (halves[i].is_leaf) {
        roots_.push_back(level[i]);
      } else {
        add_children(level[i], halves[i].left, halves[i].right, tree_.nodes, next);
      }
    }
    return next;
  }

  [[nodiscard]] Subtree<T> build_subtree(const Part<T>& root) {
    Subtree<T> made;
    made.nodes.emplace_back();
    std::vector<Part<T>> pending{root};
    pending[0].node = 0;
    while (!pending.empty()) {
      const Part<T> part = pending.back();
      pending.pop_back();
      Part<T> left, right;
      if (parts_.split(part, left, right)) {
        add_children(part, left, right, made.nodes, pending);
        continue;
      }
      made.nodes[part.node] = {part.box.box(), static_cast<uint32_t>(made.order.size()), part.count()};
      for (const Reference<T>& r : parts_.references(part)) made.order.push_back(r.item());
    }
    return made;
  }

  void build_subtrees() {
    std::vector<Subtree<T>> made(roots_.size());
    for_each_(made.size(), [&](size_t i) { made[i] = build_subtree(roots_[i]); });
    struct Place {
      size_t node, order;
    };
    std::vector<Place> places;
    Place end{tree_.nodes.size(), 0};
    for (const Subtree<T>& subtree : made) {
      places.push_back(end);
      end.node += subtree.nodes.size() - 1;
      end.order += subtree.order.size();
    }
    tree_.nodes.resize(end.node);
    tree_.order.resize(end.order);
    for_each_(made.size(), [&](size_t i) {
      const auto node = static_cast<uint32_t>(places[i].node), order = static_cast<uint32_t>(places[i].order);
      for (size_t k = 0; k < made[i].nodes.size(); ++k) {
        Node<T>& to = tree_.nodes[k == 0 ? roots_[i].node : node + k - 1];
        to = made[i].nodes[k];
        to.first += to.is_leaf() ? order : node - 1;
      }
      std::copy(made[i].order.begin(), made[i].order.end(),
                tree_.order.begin() + static_cast<std::ptrdiff_t>(order));
    });
  }

  std::span<const Box<T>> items_;
  const ForEach& for_each_;
  size_t most_;
  CuttingParts<T> parts_;
  std::vector<Part<T>> roots_;  // of subtrees
  Hierarchy<T> tree_;
};

}  // namespace

template <class T>
Hierarchy<T> build_sbvh(std::span<const Box<T>> items, const CutOptions& options, int leaf_size, int block,
                        const ForEach& for_each) {
  return items.empty() ? Hierarchy<T>{} : CuttingBuilder<T>(items, options, leaf_size, block, for_each).run();
}

template Hierarchy<float> build_sbvh(std::span<const Box<float>>, const CutOptions&, int, int,
                                     const ForEach&);
template Hierarchy<double> build_sbvh(std::span<const Box<double>>, const CutOptions&, int, int,
                                      const ForEach&);

}  // namespace raysweep
