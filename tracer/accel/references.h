// What the builder by area moves about: items with their boxes, in vectors of four numbers.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <type_traits>

#include "tracer/math/box.h"

namespace raysweep {

/// x, y, z and a fourth that fills the vector. GCC and Clang know such types; `a < b ? a : b` is a vector's
/// minimum.
template <class T>
struct LaneTypes {
  using Count = std::conditional_t<sizeof(T) == 4, int32_t, int64_t>;
  typedef T Lanes __attribute__((vector_size(4 * sizeof(T))));
  typedef Count Counts __attribute__((vector_size(4 * sizeof(T))));
};
template <class T>
using Lanes = typename LaneTypes<T>::Lanes;
template <class T>
using Counts = typename LaneTypes<T>::Counts;

/// A box in lanes. Not set to anything where it is not said: bins are many.
template <class T>
struct LaneBox {
  Lanes<T> lower, upper;

  [[nodiscard]] static LaneBox empty() {
    constexpr T inf = Box<T>::inf;
    return {Lanes<T>{inf, inf, inf, inf}, Lanes<T>{-inf, -inf, -inf, -inf}};
  }
  void include(const Lanes<T>& low, const Lanes<T>& high) {
    lower = low < lower ? low : lower;
    upper = high > upper ? high : upper;
  }
  void include(const LaneBox& other) { include(other.lower, other.upper); }
  [[nodiscard]] bool is_point() const {
    return lower[0] == upper[0] && lower[1] == upper[1] && lower[2] == upper[2];
  }
  [[nodiscard]] Box<T> box() const {
    Box<T> result;
    result.bounds[0] = {lower[0], lower[1], lower[2]};
    result.bounds[1] = {upper[0], upper[1], upper[2]};
    return result;
  }
};

/// An item and its box. The fourth lanes hold the item's number in two halves, which any T holds exactly.
template <class T>
struct Reference {
  static constexpr int half_bits = 16;
  Lanes<T> lower, upper;

  void set(const Box<T>& box, uint32_t item) {
    constexpr uint32_t mask = (1u << half_bits) - 1;
    lower = Lanes<T>{box.lower().x, box.lower().y, box.lower().z, static_cast<T>(item & mask)};
    upper = Lanes<T>{box.upper().x, box.upper().y, box.upper().z, static_cast<T>(item >> half_bits)};
  }
  [[nodiscard]] uint32_t item() const {
    return (static_cast<uint32_t>(upper[3]) << half_bits) + static_cast<uint32_t>(lower[3]);
  }
};

/// The box around twice the centres.
template <class T>
[[nodiscard]] LaneBox<T> bounds_of_centres(std::span<const Reference<T>> references) {
  LaneBox<T> centres = LaneBox<T>::empty();
  for (const Reference<T>& reference : references) {
    const Lanes<T> c = reference.lower + reference.upper;
    centres.include(c, c);
  }
  return centres;
}

inline constexpr int most_bins = 16;

/// From centres to bins, of which each axis has `count`. What is no number, as the difference of infinite
/// centres, belongs to the first.
template <class T>
struct BinMapping {
  Lanes<T> low, scale, last;
  int count;

  BinMapping(const LaneBox<T>& centres, int bins) : low(centres.lower), scale{}, count(bins) {
    const T n = static_cast<T>(bins);
    last = Lanes<T>{n - 1, n - 1, n - 1, n - 1};
    const Lanes<T> extent = centres.upper - centres.lower;
    for (int axis = 0; axis < 3; ++axis)
      if (extent[axis] > 0) scale[axis] = n / extent[axis];
  }

  /// The bins by axis, not rounded down yet.
  void place(const Reference<T>& reference, Lanes<T>& place) const {
    const Lanes<T> at = (reference.lower + reference.upper - low) * scale, zero{};
    place = at > zero ? at : zero;
    place = place < last ? place : last;
  }
  /// Whether `place` puts the reference into bin `plane`, at least 1, or a later one. The same operations
  /// decide: no item is counted on one side and goes to the other.
  [[nodiscard]] bool is_right(const Reference<T>& reference, int axis, T plane) const {
    return (reference.lower[axis] + reference.upper[axis] - low[axis]) * scale[axis] >= plane;
  }
};

/// Boxes and counts of the references in each bin of each axis.
template <class T>
struct Bins {
  /// One of each axis. As large as a power of two, so that to find it takes one shift.
  struct alignas(4 * sizeof(LaneBox<T>)) Bin {
    LaneBox<T> box[3];
    Counts<T> count;  // by axis
  };
  Bin bin[most_bins];

  Bins() {}  // not set, which is for whoever fills them
  explicit Bins(int used) {
    for (Bin& b : std::span(bin, static_cast<size_t>(used))) {
      std::fill_n(b.box, 3, LaneBox<T>::empty());
      b.count = Counts<T>{};
    }
  }

  void add(const Reference<T>& reference, const BinMapping<T>& mapping) {
    const Lanes<T> lower = reference.lower, upper = reference.upper;
    Lanes<T> place;
    mapping.place(reference, place);
    for (int axis = 0; axis < 3; ++axis) {
      const auto b = static_cast<int64_t>(place[axis]);
      bin[b].box[axis].include(lower, upper);
      bin[b].count[axis]++;
    }
  }
  /// Neighbours often fall into one bin, where each would wait for the one before it: so the four quarters
  /// take turns, and where there are many, in bins of their own.
  void add(std::span<const Reference<T>> references, const BinMapping<T>& shared) {
    const BinMapping<T> mapping = shared;  // kept in registers: nothing written here can be part of it
    constexpr size_t many = 1024;
    const size_t quarter = references.size() / 4;
    const Reference<T>* reference = references.data();
    if (quarter * 4 < many) {
      for (size_t i = 0; i < quarter; ++i, ++reference)
        for (size_t turn = 0; turn < 4; ++turn) add(reference[turn * quarter], mapping);
    } else {
      Bins others[3]{Bins(most_bins), Bins(most_bins), Bins(most_bins)};
      for (size_t i = 0; i < quarter; ++i, ++reference) {
        add(reference[0], mapping);
        for (size_t turn = 1; turn < 4; ++turn) others[turn - 1].add(reference[turn * quarter], mapping);
      }
      for (const Bins& other : others) add(other, mapping.count);
    }
    for (const Reference<T>& rest : references.subspan(4 * quarter)) add(rest, mapping);
  }
  void add(const Bins& other, int used) {
    for (int b = 0; b < used; ++b) {
      for (int axis = 0; axis < 3; ++axis) bin[b].box[axis].include(other.bin[b].box[axis]);
      bin[b].count += other.bin[b].count;
    }
  }
};

/// Copies those left of `plane` to `left` and the others to `right`, in their order; how many are left.
/// Without branches: they would be guessed wrong half of the time.
template <class T>
size_t partition(std::span<const Reference<T>> references, const BinMapping<T>& mapping, int axis, int plane,
                 Reference<T>* left, Reference<T>* right) {
  const T from = static_cast<T>(plane);
  Reference<T>* const begin = left;
  std::ptrdiff_t gap = right - left;
  for (const Reference<T>& reference : references) {
    const auto is_right = static_cast<std::ptrdiff_t>(mapping.is_right(reference, axis, from));
    left[gap & -is_right] = reference;
    left += 1 - is_right;
    gap += 2 * is_right - 1;
  }
  return static_cast<size_t>(left - begin);
}

}  // namespace raysweep
