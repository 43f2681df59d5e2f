// Where cases come from: one function a file.
#pragma once

#include <utility>

#include "experiments/intersection/case.h"

namespace raysweep {

/// Rays at edges and corners of closed meshes: W1, W2, W3, F2, F2e.
[[nodiscard]] std::vector<Case> mesh_cases();
/// Meshes on which rays are aligned with edges: W4–W7.
[[nodiscard]] std::vector<Case> aligned_cases();
/// Triangles of all sizes, near and far: S1–S4, F1, E1, E4.
[[nodiscard]] std::vector<Case> scale_cases();
/// Thin, flat and no triangles: D1–D5, E5, N8.
[[nodiscard]] std::vector<Case> shape_cases();
/// Unusual numbers: N2, N4, N6.
[[nodiscard]] std::vector<Case> number_cases();
/// Where a ray begins and ends: E3, E6, E7.
[[nodiscard]] std::vector<Case> end_cases();

/// `head` with `make(trials, difficulty, random, count)` for floats and doubles.
template <class Make>
[[nodiscard]] Case with_maker(Case head, Make make) {
  head.of_floats = make;
  head.of_doubles = make;
  return head;
}

/// `head` with `add(trials, difficulty, random)` for each ray.
template <class Add>
[[nodiscard]] Case with_each(Case head, Add add) {
  return with_maker(std::move(head), [add](auto& trials, double difficulty, Random& random, size_t count) {
    while (trials.rays.size() < count) add(trials, difficulty, random);
  });
}

/// The type of numbers of what `with_maker` and `with_each` hand over.
template <class T>
T number_type(const Trials<T>&);
template <class SomeTrials>
using NumberOf = decltype(number_type(std::declval<const SomeTrials&>()));

}  // namespace raysweep
