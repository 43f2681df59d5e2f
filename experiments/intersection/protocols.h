// Lists of tests for kernels to be timed on, each by a protocol of the literature.
#pragma once

#include <string_view>
#include <vector>

#include "experiments/intersection/kernel.h"

namespace raysweep {

/// Triangles of a ray in the protocols with a hit rate: a multiple of `widest_group`, of which every tenth is
/// a whole number.
constexpr uint32_t run_length = 80;

/// How tests come about. What is not of a scene is made of the seed alone, in float: as doubles they are the
/// same numbers, so that both precisions do the same tests.
struct Protocol {
  std::string_view name, summary;
  bool has_hit_rate;  // its parameter: what share of tests are hits, in steps of 1/`run_length`
  bool has_size;      // its parameter: as many rays, and as many triangles
  bool has_scene;
  uint32_t rays_a_visit;
  Workload<float> (*make)(double parameter, uint64_t seed);  // null for those of a scene: see replay.h
};

/// The one list of protocols.
[[nodiscard]] const std::vector<Protocol>& all_protocols();

/// Null for an unknown name.
[[nodiscard]] const Protocol* find_protocol(std::string_view name);

/// How many rays and triangles "clusters" has, each.
[[nodiscard]] const std::vector<double>& cluster_sizes();

/// The same tests over numbers of another type.
template <class T>
[[nodiscard]] Workload<T> work_in(const Workload<float>& work);

/// The tests of thread `index` of `count`: as many visits as the others have, but for one, that follow each
/// other. Rays and triangles are its own copies.
template <class T>
[[nodiscard]] Workload<T> share_of(const Workload<T>& work, uint32_t index, uint32_t count);

/// Whether rounding may decide a test: not where all computing with 24 bits agrees.
enum class Clarity { hit, miss, unclear };

/// A test is unclear where its answer changes if the ray's point in the triangle's plane moves by 2⁻¹⁶ of the
/// largest coordinate on the way, divided by the cosine at which the ray meets the plane: 256 roundings of
/// floats.
[[nodiscard]] Clarity clarity_of(const Ray<float>& ray, const Triangle<float>& triangle, float t_max);

/// What is known of a list of tests without any method.
struct KnownHits {
  uint64_t hits = 0, unclear = 0;  // `hits` are the clear ones
};
[[nodiscard]] KnownHits known_hits(const Workload<float>& work);

}  // namespace raysweep
