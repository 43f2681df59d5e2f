// Planes that cut boxes in two (Stich, Friedrich & Dietrich 2009, "Spatial splits in bounding volume
// hierarchies").
#pragma once

#include "tracer/accel/references.h"

namespace raysweep {

/// A plane that cuts space, and what it makes of a part's references.
template <class T>
struct SpatialPlane {
  T cost = Box<T>::inf;  // area × blocks, of both sides; infinite where no plane has references on both
  int axis = 0;
  T at = 0;
  LaneBox<T> left = LaneBox<T>::empty(), right = LaneBox<T>::empty();
  uint32_t left_count = 0, right_count = 0;

  /// What is flat and lies in the plane is left.
  [[nodiscard]] bool is_left(const Reference<T>& r) const { return !(r.upper[axis] > at); }
  [[nodiscard]] bool is_right(const Reference<T>& r) const {
    return r.upper[axis] > at && r.lower[axis] >= at;
  }
  [[nodiscard]] Reference<T> left_of(Reference<T> r) const {
    r.upper[axis] = at;
    return r;
  }
  [[nodiscard]] Reference<T> right_of(Reference<T> r) const {
    r.lower[axis] = at;
    return r;
  }
};

/// A part's references, cut at planes at equal distances across one axis of its box.
template <class T>
class SpatialBins {
 public:
  /// None of the items below `whole_count` is cut: it belongs where its centre is.
  SpatialBins(const LaneBox<T>& around, int axis, int count, uint32_t whole_count)
      : axis_(axis), count_(count), whole_count_(whole_count) {
    const T low = around.lower[axis], step = (around.upper[axis] - low) / static_cast<T>(count);
    for (int b = 1; b < count; ++b) plane_[b] = low + static_cast<T>(b) * step;
    plane_[0] = -Box<T>::inf;
    plane_[count] = Box<T>::inf;
    std::fill_n(box_, count, LaneBox<T>::empty());
  }

  void add(std::span<const Reference<T>> references) {
    for (const Reference<T>& r : references) {
      if (r.item() < whole_count_) {
        const T centre = (r.lower[axis_] + r.upper[axis_]) / 2;
        add(r, bin_of(centre), bin_of(centre));
      } else {
        const int last = last_bin_of(r.upper[axis_]);
        add(r, std::min(bin_of(r.lower[axis_]), last), last);
      }
    }
  }

  /// The cheapest plane that makes at most `most` references of them. `1 << block_shift` of them are tested
  /// at once and cost as much as one.
  [[nodiscard]] SpatialPlane<T> cheapest(uint32_t most, int block_shift) const {
    LaneBox<T> right[most_bins];
    uint32_t right_count[most_bins];
    LaneBox<T> box = LaneBox<T>::empty();
    uint32_t count = 0;
    for (int b = count_ - 1; b > 0; --b) {
      box.include(box_[b]);
      right[b] = box;
      right_count[b] = count += ends_[b];
    }
    SpatialPlane<T> best;
    box = LaneBox<T>::empty();
    count = 0;
    for (int b = 1; b < count_; ++b) {
      box.include(box_[b - 1]);
      count += begins_[b - 1];
      if (count == 0 || right_count[b] == 0 || right_count[b] > most - count) continue;
      const T cost = side_cost(box, count, block_shift) + side_cost(right[b], right_count[b], block_shift);
      if (cost < best.cost) best = {cost, axis_, plane_[b], box, right[b], count, right_count[b]};
    }
    return best;
  }

 private:
  [[nodiscard]] static T side_cost(const LaneBox<T>& box, uint32_t count, int block_shift) {
    return box.box().half_area() * static_cast<T>(((count - 1) >> block_shift) + 1);
  }
  [[nodiscard]] int bin_of(T at) const {
    int bin = 0;
    for (int b = 1; b < count_; ++b) bin += at >= plane_[b] ? 1 : 0;
    return bin;
  }
  [[nodiscard]] int last_bin_of(T upper) const {
    int bin = 0;
    for (int b = 1; b < count_; ++b) bin += upper > plane_[b] ? 1 : 0;
    return bin;
  }
  void add(const Reference<T>& r, int first, int last) {
    begins_[first]++;
    ends_[last]++;
    if (first == last) return box_[first].include(r.lower, r.upper);
    for (int b = first; b <= last; ++b) {
      LaneBox<T> part{r.lower, r.upper};
      part.lower[axis_] = std::max(r.lower[axis_], plane_[b]);
      part.upper[axis_] = std::min(r.upper[axis_], plane_[b + 1]);
      box_[b].include(part);
    }
  }

  int axis_, count_;
  uint32_t whole_count_;
  T plane_[most_bins + 1];  // bin b lies between planes b and b + 1
  LaneBox<T> box_[most_bins];
  uint32_t begins_[most_bins] = {}, ends_[most_bins] = {};
};

}  // namespace raysweep
