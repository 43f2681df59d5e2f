// Parts of a set of references that may be cut in two (Stich, Friedrich & Dietrich 2009, "Spatial splits in
// bounding volume hierarchies").
#pragma once

#include <cmath>

#include "tracer/accel/parts.h"
#include "tracer/accel/spatial_bins.h"

namespace raysweep {

/// As Parts, but where the sides of the best plane overlap, planes that cut references are tried too, as long
/// as a part has room for more of them.
template <class T>
class CuttingParts : public Parts<T> {
 public:
  /// `most` references at most; none of the items below `whole_count` is cut.
  CuttingParts(size_t most, int leaf_size, int block, uint32_t whole_count)
      : Parts<T>(most, leaf_size, block), whole_count_(whole_count) {}

  /// The box around everything, which tells what overlap is small.
  void set_bounds(const Box<T>& bounds) {
    constexpr T alpha = T(1e-5);  // the paper's
    least_overlap_ = alpha * bounds.half_area();
  }

  /// False for a leaf.
  [[nodiscard]] bool split(const Part<T>& part, Part<T>& left, Part<T>& right) {
    if (!this->takes_a_plane(part)) return this->split_without_plane(part, left, right);
    const BinMapping<T> bin_of = this->mapping(part);
    Bins<T> bins(bin_of.count);
    this->steps().fill(bins, this->references(part), bin_of);
    const SplitPlane<T> best = this->steps().cheapest(bins, bin_of.count, this->block_shift());
    if (part.room > 0 && overlap(best) > least_overlap_) {
      const SpatialPlane<T> cut = cheapest_cut(part, bin_of.count);
      if (cut.cost < best.cost && tree_cost(cut) < tree_cost(best, part) && this->pays(part, cut.cost)) {
        cut_at(part, cut, left, right);
        return true;
      }
    }
    return this->pays(part, best.cost) && this->split_at(part, bin_of, best, left, right);
  }

 private:
  /// What both sides cost as balanced trees whose boxes are no smaller than the side's, where `cost` takes
  /// each for a leaf. The truth is between the two: with leaves alone in mind, a few large triangles around
  /// many small ones seem to be worth cutting, though the next plane would part them from the others.
  [[nodiscard]] static T tree_cost(const LaneBox<T>& left, uint32_t left_count, const LaneBox<T>& right,
                                   uint32_t right_count) {
    return left.box().half_area() * depth(left_count) + right.box().half_area() * depth(right_count);
  }
  [[nodiscard]] static T tree_cost(const SpatialPlane<T>& cut) {
    return tree_cost(cut.left, cut.left_count, cut.right, cut.right_count);
  }
  [[nodiscard]] static T tree_cost(const SplitPlane<T>& plane, const Part<T>& part) {
    if (!(plane.cost < Box<T>::inf)) return Box<T>::inf;
    return tree_cost(plane.left, plane.left_count, plane.right, part.count() - plane.left_count);
  }
  /// The logarithm of 2·count to the base 2, exact for powers of two, on a straight line between them.
  [[nodiscard]] static T depth(uint32_t count) {
    const int bits = std::bit_width(count);
    return static_cast<T>(bits) + static_cast<T>(std::ldexp(static_cast<double>(count), 1 - bits) - 1);
  }

  /// Half the surface of the box in which both sides are; infinite where there are none.
  [[nodiscard]] static T overlap(const SplitPlane<T>& plane) {
    if (!(plane.cost < Box<T>::inf)) return Box<T>::inf;
    LaneBox<T> both = plane.left;
    both.lower = plane.right.lower > both.lower ? plane.right.lower : both.lower;
    both.upper = plane.right.upper < both.upper ? plane.right.upper : both.upper;
    for (int axis = 0; axis < 3; ++axis)
      if (both.lower[axis] > both.upper[axis]) return 0;
    return both.box().half_area();
  }

  [[nodiscard]] SpatialPlane<T> cheapest_cut(const Part<T>& part, int bin_count) {
    SpatialPlane<T> best;
    for (int axis = 0; axis < 3; ++axis) {
      SpatialBins<T> bins(part.box, axis, bin_count, whole_count_);
      bins.add(this->references(part));
      const SpatialPlane<T> of_axis = bins.cheapest(part.count() + part.room, this->block_shift());
      if (of_axis.cost < best.cost) best = of_axis;
    }
    return best;
  }

  /// The left side is written to where both sides may lie from its beginning on, the right one backwards from
  /// its end, until it is known how many there are.
  void cut_at(const Part<T>& part, SpatialPlane<T> plane, Part<T>& left, Part<T>& right) {
    left = right = Part<T>::of(part.begin, part.end + part.room, part.depth + 1, 1 - part.buffer);
    const std::span<Reference<T>> both = this->references(left);
    Reference<T>*to_left = both.data(), *const end = both.data() + both.size(), *to_right = end;
    for (const Reference<T>& r : this->references(part)) {
      const Side side = side_of(r, plane);
      if (side == Side::both) {
        *to_left++ = plane.left_of(r);
        *--to_right = plane.right_of(r);
      } else if (side == Side::left) {
        *to_left++ = r;
      } else {
        *--to_right = r;
      }
    }
    const auto left_count = static_cast<uint32_t>(to_left - both.data()),
               right_count = static_cast<uint32_t>(end - to_right);
    this->share(part, left_count, right_count, left, right);
    std::copy(to_right, end, this->references(right).data());
    set_boxes(left);
    set_boxes(right);
  }

  enum class Side { left, right, both };

  /// Where a reference goes. One that the plane cuts may be cheaper whole on one side (the paper's "reference
  /// unsplitting"), which `plane` then takes account of.
  [[nodiscard]] Side side_of(const Reference<T>& r, SpatialPlane<T>& plane) const {
    if (r.item() < whole_count_)
      return (r.lower[plane.axis] + r.upper[plane.axis]) / 2 >= plane.at ? Side::right : Side::left;
    if (plane.is_left(r)) return Side::left;
    if (plane.is_right(r)) return Side::right;
    LaneBox<T> wide_left = plane.left, wide_right = plane.right;
    wide_left.include(r.lower, r.upper);
    wide_right.include(r.lower, r.upper);
    const auto cost = [](const LaneBox<T>& box, uint32_t count) {
      return box.box().half_area() * static_cast<T>(count);
    };
    const T cut = cost(plane.left, plane.left_count) + cost(plane.right, plane.right_count);
    constexpr T inf = Box<T>::inf;  // neither side is emptied
    const T as_left = plane.right_count == 1
                          ? inf
                          : cost(wide_left, plane.left_count) + cost(plane.right, plane.right_count - 1);
    const T as_right = plane.left_count == 1
                           ? inf
                           : cost(plane.left, plane.left_count - 1) + cost(wide_right, plane.right_count);
    if (!(std::min(as_left, as_right) < cut)) return Side::both;
    const bool is_left = as_left <= as_right;
    (is_left ? plane.left : plane.right) = is_left ? wide_left : wide_right;
    (is_left ? plane.right_count : plane.left_count)--;
    return is_left ? Side::left : Side::right;
  }

  void set_boxes(Part<T>& part) {
    for (const Reference<T>& r : this->references(part)) part.box.include(r.lower, r.upper);
    part.centres = bounds_of_centres<T>(this->references(part));
  }

  uint32_t whole_count_;
  T least_overlap_ = 0;
};

}  // namespace raysweep
