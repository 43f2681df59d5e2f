// The surface area heuristic over bins (Wald 2007, "On fast construction of SAH-based bounding volume
// hierarchies").
#pragma once

#include "tracer/accel/references.h"

namespace raysweep {

/// A plane between two bins.
template <class T>
struct SplitPlane {
  T cost = Box<T>::inf;   // area × blocks, of both sides; infinite where no plane has items on both
  int axis = 0, bin = 0;  // the first bin on the right
  LaneBox<T> left, right;
  uint32_t left_count = 0;
};

/// `cost[axis]` of one side, whose box by axis is `boxes[axis]`: `1 << block_shift` items are tested at once
/// and cost as much as one. An empty side's box has an infinite area, and inf × 0 is no number, which is
/// never cheaper.
template <class T>
void cost_by_axis(const LaneBox<T> (&boxes)[3], const Counts<T>& items, int block_shift, Lanes<T>& cost) {
  Lanes<T> x{}, y{}, z{};
  for (int axis = 0; axis < 3; ++axis) {
    const Lanes<T> size = boxes[axis].upper - boxes[axis].lower;
    x[axis] = size[0];
    y[axis] = size[1];
    z[axis] = size[2];
  }
  const Counts<T> blocks = (items + ((1 << block_shift) - 1)) >> block_shift;
  cost = (x * y + y * z + z * x) * __builtin_convertvector(blocks, Lanes<T>);
}

/// Sweeps over the planes of all axes at once.
template <class T>
class PlaneSweep {
 public:
  PlaneSweep(const Bins<T>& bins, int count, int block_shift)
      : bins_(bins), count_(count), block_shift_(block_shift) {}

  [[nodiscard]] SplitPlane<T> cheapest() {
    Lanes<T> right_cost[most_bins];
    start();
    for (int b = count_ - 1; b > 0; --b) take(b, right_cost[b]);
    constexpr T inf = Box<T>::inf;
    Lanes<T> least{inf, inf, inf, inf};
    Counts<T> first_right{};
    start();
    for (int b = 1; b < count_; ++b) {
      Lanes<T> cost;
      take(b - 1, cost);
      cost += right_cost[b];
      first_right = cost < least ? Counts<T>{b, b, b, b} : first_right;
      least = cost < least ? cost : least;
    }
    SplitPlane<T> best;
    for (int axis = 0; axis < 3; ++axis) {
      if (!(least[axis] < best.cost)) continue;
      best.cost = least[axis];
      best.axis = axis;
      best.bin = static_cast<int>(first_right[axis]);
    }
    set_sides(best);
    return best;
  }

 private:
  void start() {
    std::fill_n(boxes_, 3, LaneBox<T>::empty());
    items_ = Counts<T>{};
  }
  /// Adds bin `b` to the side, which then costs `cost`.
  void take(int b, Lanes<T>& cost) {
    for (int axis = 0; axis < 3; ++axis) boxes_[axis].include(bins_.bin[b].box[axis]);
    items_ += bins_.bin[b].count;
    cost_by_axis<T>(boxes_, items_, block_shift_, cost);
  }
  void set_sides(SplitPlane<T>& plane) const {
    plane.left = plane.right = LaneBox<T>::empty();
    for (int b = 0; b < count_; ++b) {
      const bool is_left = b < plane.bin;
      (is_left ? plane.left : plane.right).include(bins_.bin[b].box[plane.axis]);
      if (is_left) plane.left_count += static_cast<uint32_t>(bins_.bin[b].count[plane.axis]);
    }
  }

  const Bins<T>& bins_;
  int count_, block_shift_;
  LaneBox<T> boxes_[3];
  Counts<T> items_;
};

}  // namespace raysweep
