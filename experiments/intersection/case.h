// Cases of the failure catalogue: rays and triangles at which methods of intersection fail, made from a seed.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string_view>
#include <vector>

#include "results/statistics/random.h"
#include "tracer/intersect/intersector.h"

namespace raysweep {

/// A ray, and the triangles among which it is decided.
template <class T>
struct Trial {
  Ray<T> ray;
  T t_max = std::numeric_limits<T>::infinity();
  uint32_t first = 0, count = 0;  // its candidates in `Trials::candidates`
};

/// Rays and their triangles. Each ray has candidates: its one triangle, or those of a mesh that meet at the
/// edge or corner that it is aimed at; the others of the mesh are too far away to be hit there.
template <class T>
struct Trials {
  std::vector<Triangle<T>> triangles;
  std::vector<uint32_t> candidates;  // indices of `triangles`
  std::vector<Trial<T>> rays;

  /// A ray with a triangle of its own.
  void add(const Ray<T>& ray, const Triangle<T>& triangle, T t_max = std::numeric_limits<T>::infinity()) {
    triangles.push_back(triangle);
    add(ray, std::vector<uint32_t>{static_cast<uint32_t>(triangles.size() - 1)}, t_max);
  }
  /// A ray with triangles that are there.
  void add(const Ray<T>& ray, const std::vector<uint32_t>& of_ray,
           T t_max = std::numeric_limits<T>::infinity()) {
    rays.push_back(
        {ray, t_max, static_cast<uint32_t>(candidates.size()), static_cast<uint32_t>(of_ray.size())});
    candidates.insert(candidates.end(), of_ray.begin(), of_ray.end());
  }
};

/// What is right. `decided`: what the oracle says of each pair of ray and triangle; `covered`: besides, each
/// ray hits at least one of its candidates; `must_miss`: no hit, even where the oracle finds a boundary.
enum class Expectation { decided, covered, must_miss };

/// One case: `difficulty` says what its values mean, and their unit; they are sorted from easy to hard, or
/// number kinds.
struct Case {
  template <class T>
  using Maker = std::function<void(Trials<T>& trials, double difficulty, Random& random, size_t count)>;

  std::string_view id{}, title{}, source{};
  Expectation expectation{};
  std::string_view difficulty{};
  std::vector<double> difficulties{};
  Maker<float> of_floats{};
  Maker<double> of_doubles{};

  /// `count` rays, the same for the same arguments on every machine. T is float or double.
  template <class T>
  [[nodiscard]] Trials<T> make(double value, uint64_t seed, size_t count) const {
    Trials<T> trials;
    Random random(seed);
    if constexpr (std::is_same_v<T, float>) {
      of_floats(trials, value, random, count);
    } else {
      of_doubles(trials, value, random, count);
    }
    return trials;
  }
};

/// All of them: W1–W7, F1, F2, S1–S4, D1–D5, N2, N4, N6 and N8 as the literature has them, and ours, E1–E7.
[[nodiscard]] const std::vector<Case>& all_cases();
/// The one with this id. Throws std::out_of_range for others.
[[nodiscard]] const Case& case_of(std::string_view id);

}  // namespace raysweep
