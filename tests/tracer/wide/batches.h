// Batches of test rays, and what a wide core answers to them against another core.
#pragma once

#include "tests/tracer/hit_rays.h"
#include "tracer/wide/wide_core.h"

namespace raysweep {

/// The rays with their limits.
inline RayBatch batch_of(const std::vector<TestRay<float>>& tests) {
  RayBatch rays(tests.size());
  for (size_t i = 0; i < tests.size(); ++i) rays.set(i, tests[i].ray, tests[i].t_max);
  return rays;
}

/// What a core answers to each of some rays: the nearest hit, and whether anything is in the ray's way.
struct Answers {
  std::vector<std::optional<Hit<float>>> nearest;
  std::vector<char> is_hidden;

  template <class Core>
  Answers(const Core& core, const std::vector<TestRay<float>>& rays) {
    for (const auto& [ray, t_max] : rays) {
      nearest.push_back(core.closest(ray, Hit<float>::start(), t_max));
      is_hidden.push_back(core.occluded(ray, t_max) ? 1 : 0);
    }
  }
};

/// Rays whose answers differ, bit for bit: primitive and distance; of rays with a limit also whether anything
/// is in their way. In both groupings, and each counts.
template <class Wide>
size_t count_differences(const Wide& core, const Answers& expected,
                         const std::vector<TestRay<float>>& tests) {
  const RayBatch rays = batch_of(tests);
  HitBatch nearest(tests.size()), any(tests.size());
  KernelScratch scratch;
  size_t differences = 0;
  for (const Grouping grouping : {Grouping::single, Grouping::packets}) {
    core.closest(rays, nearest, scratch, grouping);
    core.occluded(rays, any, scratch, grouping);
    for (size_t i = 0; i < tests.size(); ++i) {
      const float t_max = tests[i].t_max;
      const auto& hit = expected.nearest[i];
      const bool same = hit ? nearest.id[i] == hit->id && nearest.t[i] == hit->t
                            : nearest.id[i] == no_hit_id && (nearest.t[i] == t_max || std::isnan(t_max));
      const bool same_shadow =
          expected.is_hidden[i] != 0 ? any.id[i] != no_hit_id && any.t[i] < t_max : any.id[i] == no_hit_id;
      differences += same && same_shadow ? 0 : 1;
    }
  }
  return differences;
}

/// The same against the answers of `oracle`, which several comparisons had better share.
template <class Wide, class Oracle>
size_t count_differences(const Wide& core, const Oracle& oracle, const std::vector<TestRay<float>>& tests) {
  return count_differences(core, Answers(oracle, tests), tests);
}

/// Calls `visit(core, isa)` with the wide core of each instruction set that runs here.
template <class Method, class Visit>
void for_each_wide_core(const Scene& scene, const std::string& accel, int leaf, Visit&& visit) {
  for (const Isa& isa : built_isas()) {
    if (!runs_here(isa.name)) continue;
    if (isa.width == 4) visit(WideCore<Method, 4>(scene, accel, leaf, isa.name), isa.name);
    if (isa.width == 8) visit(WideCore<Method, 8>(scene, accel, leaf, isa.name), isa.name);
  }
}

}  // namespace raysweep
