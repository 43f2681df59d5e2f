// What splitting a part by the surface area heuristic takes time for.
#pragma once

#include "tracer/accel/split_plane.h"

namespace raysweep {

/// The same code, for float perhaps compiled for wider vectors than every processor has; what it finds is the
/// same.
template <class T>
struct SplitSteps {
  /// What went to either side.
  struct Moved {
    LaneBox<T> left, right;  // of twice the centres
    size_t left_count;
  };

  void (*fill)(Bins<T>& bins, std::span<const Reference<T>> references, const BinMapping<T>& mapping);
  SplitPlane<T> (*cheapest)(const Bins<T>& bins, int count, int block_shift);
  /// Those left of a plane between bins go to `left`, the others to `right`.
  Moved (*move)(std::span<const Reference<T>> references, const BinMapping<T>& mapping,
                const SplitPlane<T>& plane, Reference<T>* left, Reference<T>* right);

  /// The fastest that run here.
  [[nodiscard]] static SplitSteps here();
};

template <class T>
typename SplitSteps<T>::Moved move_to_sides(std::span<const Reference<T>> references,
                                            const BinMapping<T>& mapping, const SplitPlane<T>& plane,
                                            Reference<T>* left, Reference<T>* right) {
  const size_t left_count = partition<T>(references, mapping, plane.axis, plane.bin, left, right);
  return {bounds_of_centres<T>(std::span(left, left_count)),
          bounds_of_centres<T>(std::span(right, references.size() - left_count)), left_count};
}

}  // namespace raysweep
