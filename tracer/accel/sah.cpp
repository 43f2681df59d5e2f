#include <bit>
#include <memory>

#include "tracer/accel/hierarchy.h"
#include "tracer/accel/split_plane.h"

namespace raysweep {

namespace {

// Cost of visiting a node, in triangle tests: both read one cache line and do about twenty operations.
constexpr int node_cost = 1;

/// A node to be: its references are `begin … end` of one of two buffers.
template <class T>
struct Part {
  LaneBox<T> box, centres;
  uint32_t begin, end;
  int depth;
  size_t buffer;
  uint32_t node = 0;
  [[nodiscard]] uint32_t count() const { return end - begin; }
};

template <class T>
class Builder {
 public:
  Builder(std::span<const Box<T>> items, int leaf_size, int block)
      : items_(items),
        leaf_size_(static_cast<uint32_t>(leaf_size)),
        block_shift_(std::countr_zero(static_cast<uint32_t>(block))) {
    for (auto& buffer : buffers_) buffer = std::make_unique_for_overwrite<Reference<T>[]>(items.size());
    tree_.order.resize(items.size());
  }

  [[nodiscard]] Hierarchy<T> run() {
    Part<T> root = part_of(0, static_cast<uint32_t>(items_.size()), 0, 0);
    const auto references = of(root);
    for (uint32_t i = 0; i < root.end; ++i) {
      references[i].set(items_[i], i);
      root.box.include(references[i].lower, references[i].upper);
    }
    root.centres = bounds_of_centres<T>(references);
    build(root);
    return std::move(tree_);
  }

 private:
  using References = std::span<Reference<T>>;

  [[nodiscard]] static Part<T> part_of(uint32_t begin, uint32_t end, int depth, size_t buffer) {
    return {LaneBox<T>::empty(), LaneBox<T>::empty(), begin, end, depth, buffer};
  }
  [[nodiscard]] References of(const Part<T>& part) const {
    return {buffers_[part.buffer].get() + part.begin, part.count()};
  }

  void build(const Part<T>& root) {
    std::vector<Part<T>> pending{root};
    tree_.nodes.emplace_back();
    while (!pending.empty()) {
      const Part<T> part = pending.back();
      pending.pop_back();
      Node<T>& node = tree_.nodes[part.node];
      node.box = part.box.box();
      Part<T> left, right;
      if (!split(part, left, right)) {
        node.first = part.begin;
        node.count = part.count();
        for (uint32_t i = 0; i < part.count(); ++i) tree_.order[part.begin + i] = of(part)[i].item();
        continue;
      }
      node.first = left.node = static_cast<uint32_t>(tree_.nodes.size());
      right.node = left.node + 1;
      pending.push_back(right);
      pending.push_back(left);
      tree_.nodes.resize(tree_.nodes.size() + 2);
    }
  }

  /// False for a leaf.
  [[nodiscard]] bool split(const Part<T>& part, Part<T>& left, Part<T>& right) const {
    const bool may_be_leaf = part.count() <= leaf_size_;
    // One block costs less than a node.
    if (may_be_leaf && (part.count() - 1) >> block_shift_ == 0) return false;
    if (part.centres.is_point()) return false;
    if (part.depth < balanced_from_depth) return split_by_area(part, may_be_leaf, left, right);
    if (may_be_leaf) return false;
    split_evenly(part, left, right);
    return true;
  }

  [[nodiscard]] bool split_by_area(const Part<T>& part, bool may_be_leaf, Part<T>& left,
                                   Part<T>& right) const {
    // Few items need few bins: to sweep over all would take longer than to fill them.
    const BinMapping<T> mapping(part.centres,
                                static_cast<int>(std::min<uint32_t>(most_bins, 4 + part.count() / 4)));
    Bins<T> bins(mapping.count);
    bins.add(of(part), mapping);
    const SplitPlane<T> plane = PlaneSweep<T>(bins, mapping.count, block_shift_).cheapest();
    const T area = part.box.box().half_area();
    const uint32_t blocks = ((part.count() - 1) >> block_shift_) + 1;
    if (may_be_leaf && !(plane.cost + node_cost * area < area * static_cast<T>(blocks))) return false;
    if (!(plane.cost < Box<T>::inf)) {
      split_evenly(part, left, right);
      return true;
    }
    const uint32_t middle = part.begin + plane.left_count;
    left = part_of(part.begin, middle, part.depth + 1, 1 - part.buffer);
    right = part_of(middle, part.end, part.depth + 1, 1 - part.buffer);
    left.box = plane.left;
    right.box = plane.right;
    partition<T>(of(part), mapping, plane.axis, plane.bin, of(left).data(), of(right).data());
    left.centres = bounds_of_centres<T>(of(left));
    right.centres = bounds_of_centres<T>(of(right));
    return true;
  }

  /// Halves the count of items along the longest axis of the centres.
  void split_evenly(const Part<T>& part, Part<T>& left, Part<T>& right) const {
    const References all = of(part);
    const int axis = part.centres.box().longest_axis();
    const uint32_t half = part.count() / 2;
    std::nth_element(all.begin(), all.begin() + half, all.end(),
                     [axis](const Reference<T>& a, const Reference<T>& b) {
                       return a.lower[axis] + a.upper[axis] < b.lower[axis] + b.upper[axis];
                     });
    left = part_of(part.begin, part.begin + half, part.depth + 1, part.buffer);
    right = part_of(part.begin + half, part.end, part.depth + 1, part.buffer);
    for (Part<T>* side : {&left, &right}) {
      for (const Reference<T>& reference : of(*side)) side->box.include(reference.lower, reference.upper);
      side->centres = bounds_of_centres<T>(of(*side));
    }
  }

  std::span<const Box<T>> items_;
  uint32_t leaf_size_;
  int block_shift_;
  std::unique_ptr<Reference<T>[]> buffers_[2];
  Hierarchy<T> tree_;
};

}  // namespace

template <class T>
Hierarchy<T> build_sah(std::span<const Box<T>> items, int leaf_size, int block) {
  return items.empty() ? Hierarchy<T>{} : Builder<T>(items, leaf_size, block).run();
}

template Hierarchy<float> build_sah(std::span<const Box<float>>, int, int);
template Hierarchy<double> build_sah(std::span<const Box<double>>, int, int);

}  // namespace raysweep
