// Parts of a set of references, split by the surface area heuristic until they are leaves.
#pragma once

#include <bit>
#include <optional>
#include <vector>

#include "tracer/accel/hierarchy.h"
#include "tracer/accel/split_steps.h"
#include "tracer/unset_memory.h"

namespace raysweep {

/// A node to be: its references are `begin … end` of one of two buffers, where `room` more places behind them
/// are its own.
template <class T>
struct Part {
  LaneBox<T> box, centres;
  uint32_t begin, end;
  int depth;
  size_t buffer;
  uint32_t node = 0, room = 0;

  /// With empty boxes.
  [[nodiscard]] static Part of(uint32_t begin, uint32_t end, int depth, size_t buffer) {
    return {LaneBox<T>::empty(), LaneBox<T>::empty(), begin, end, depth, buffer};
  }
  [[nodiscard]] uint32_t count() const { return end - begin; }
};

/// Makes `part` an inner node, with places for its sides' nodes; the sides are split later, left first.
template <class T>
void add_children(const Part<T>& part, Part<T>& left, Part<T>& right, UnsetVector<Node<T>>& nodes,
                  std::vector<Part<T>>& to) {
  left.node = static_cast<uint32_t>(nodes.size());
  nodes[part.node] = {part.box.box(), left.node, 0};
  right.node = left.node + 1;
  to.push_back(right);
  to.push_back(left);
  nodes.resize(nodes.size() + 2);
}

/// All references, `count` of them at most, in two buffers between which they are copied to and fro.
/// Different parts may be worked on at the same time.
template <class T>
class Parts {
 public:
  Parts(size_t count, int leaf_size, int block)
      : leaf_size_(static_cast<uint32_t>(leaf_size)),
        block_shift_(std::countr_zero(static_cast<uint32_t>(block))) {
    for (auto& buffer : buffers_) buffer.resize(count);
  }

  [[nodiscard]] const SplitSteps<T>& steps() const { return steps_; }
  [[nodiscard]] std::span<Reference<T>> references(const Part<T>& part) {
    return std::span(buffers_[part.buffer]).subspan(part.begin, part.count());
  }

  /// Whether a plane between bins may split this part; otherwise it is a leaf or halved by count.
  [[nodiscard]] bool takes_a_plane(const Part<T>& part) const {
    return !is_one_block(part) && !part.centres.is_point() && part.depth < balanced_from_depth;
  }
  /// Few items need few bins: to sweep over all would take longer than to fill them.
  [[nodiscard]] static BinMapping<T> mapping(const Part<T>& part) {
    return {part.centres, static_cast<int>(std::clamp<uint32_t>(part.count() / 2, 4, most_bins))};
  }
  /// None where a leaf is no dearer. The plane's cost is infinite where all are.
  [[nodiscard]] std::optional<SplitPlane<T>> plane(const Part<T>& part, const Bins<T>& bins,
                                                   int count) const {
    const SplitPlane<T> best = steps_.cheapest(bins, count, block_shift_);
    return pays(part, best.cost) ? std::optional(best) : std::nullopt;
  }
  /// The parts that `plane` makes of `part`, without their centres.
  static void divide(const Part<T>& part, const SplitPlane<T>& plane, Part<T>& left, Part<T>& right) {
    share(part, plane.left_count, part.count() - plane.left_count, left, right);
    left.box = plane.left;
    right.box = plane.right;
  }

  /// False for a leaf.
  [[nodiscard]] bool split(const Part<T>& part, Part<T>& left, Part<T>& right) {
    if (takes_a_plane(part)) {
      const BinMapping<T> bin_of = mapping(part);
      Bins<T> bins(bin_of.count);
      steps_.fill(bins, references(part), bin_of);
      const auto best = plane(part, bins, bin_of.count);
      if (!best) return false;
      return split_at(part, bin_of, *best, left, right);
    }
    return split_without_plane(part, left, right);
  }

 protected:
  /// Whether to split at that cost, area × blocks of both sides, is cheaper than a leaf, or must be.
  [[nodiscard]] bool pays(const Part<T>& part, T cost) const {
    // Of visiting a node, in triangle tests: both read one cache line and do about twenty operations.
    constexpr T node_cost = 1;
    const T area = part.box.box().half_area();
    const uint32_t blocks = ((part.count() - 1) >> block_shift_) + 1;
    return cost + node_cost * area < area * static_cast<T>(blocks) || part.count() > leaf_size_;
  }
  /// As `split`, by the cheapest plane between bins.
  bool split_at(const Part<T>& part, const BinMapping<T>& bin_of, const SplitPlane<T>& best, Part<T>& left,
                Part<T>& right) {
    if (!(best.cost < Box<T>::inf)) return split_without_plane(part, left, right);
    divide(part, best, left, right);
    const auto moved =
        steps_.move(references(part), bin_of, best, references(left).data(), references(right).data());
    left.centres = moved.left;
    right.centres = moved.right;
    return true;
  }
  /// As `split`.
  bool split_without_plane(const Part<T>& part, Part<T>& left, Part<T>& right) {
    if (part.count() <= leaf_size_ || part.centres.is_point()) return false;
    split_evenly(part, left, right);
    return true;
  }
  /// Places for both sides in the other buffer; the room that is left goes to each by its count.
  static void share(const Part<T>& part, uint32_t left_count, uint32_t right_count, Part<T>& left,
                    Part<T>& right) {
    const uint32_t room = part.count() + part.room - left_count - right_count;
    const auto of_left =
        room == 0 ? 0 : static_cast<uint32_t>(uint64_t{room} * left_count / (left_count + right_count));
    const uint32_t middle = part.begin + left_count + of_left;
    left = Part<T>::of(part.begin, part.begin + left_count, part.depth + 1, 1 - part.buffer);
    right = Part<T>::of(middle, middle + right_count, part.depth + 1, 1 - part.buffer);
    left.room = of_left;
    right.room = room - of_left;
  }

  [[nodiscard]] int block_shift() const { return block_shift_; }

 private:
  /// What is tested at once costs less than a node.
  [[nodiscard]] bool is_one_block(const Part<T>& part) const {
    return part.count() <= leaf_size_ && (part.count() - 1) >> block_shift_ == 0;
  }

  /// Halves the count of items along the longest axis of the centres.
  void split_evenly(const Part<T>& part, Part<T>& left, Part<T>& right) {
    const std::span<Reference<T>> all = references(part);
    const int axis = part.centres.box().longest_axis();
    const uint32_t half = part.count() / 2;
    std::nth_element(all.begin(), all.begin() + half, all.end(),
                     [axis](const Reference<T>& a, const Reference<T>& b) {
                       return a.lower[axis] + a.upper[axis] < b.lower[axis] + b.upper[axis];
                     });
    left = Part<T>::of(part.begin, part.begin + half, part.depth + 1, part.buffer);
    right = Part<T>::of(part.begin + half, part.end, part.depth + 1, part.buffer);
    right.room = part.room;
    for (Part<T>* side : {&left, &right}) {
      for (const Reference<T>& r : references(*side)) side->box.include(r.lower, r.upper);
      side->centres = bounds_of_centres<T>(references(*side));
    }
  }

  const SplitSteps<T> steps_ = SplitSteps<T>::here();
  uint32_t leaf_size_;
  int block_shift_;
  UnsetVector<Reference<T>> buffers_[2];
};

}  // namespace raysweep
