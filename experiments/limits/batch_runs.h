// Rays of one kind through the wide core, in one thread: what they visit, and how long that takes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "experiments/peers/rays.h"
#include "tracer/wide/visit_counts.h"
#include "tracer/wide/wide_core.h"

namespace raysweep {

/// One way to trace a batch.
struct BatchRun {
  std::string isa;
  Grouping grouping{};
  size_t rays = 0;
  std::function<VisitCounts()> trace;  // once; what has been visited, of cores that count
};

/// Cores of one scene without planes and spheres, by instruction set, and the rays sent out for them.
class SceneRuns {
 public:
  /// `isas` have to run here.
  SceneRuns(Scene scene, const std::vector<std::string>& isas);

  [[nodiscard]] size_t triangle_count() const { return scene_.triangle_count(); }
  /// In every grouping on every instruction set. They share the rays.
  [[nodiscard]] std::vector<BatchRun> runs(RayKind kind, int width, int height) const;

 private:
  using Trace = std::function<void(const RayBatch& rays, HitBatch& hits, KernelScratch& scratch, bool any_hit,
                                   Grouping grouping)>;

  Scene scene_;
  OracleCore oracle_;
  std::vector<std::pair<std::string, Trace>> cores_;
};

/// Processor time of the calling thread for one run, in seconds: the median over `rounds`, in each of which
/// every run is repeated for `seconds` at least, one run after the other.
[[nodiscard]] std::vector<double> cpu_seconds(const std::vector<BatchRun>& runs, int rounds, double seconds);

/// Cycles in a nanosecond of the calling thread's processor time now.
[[nodiscard]] double measure_gigahertz();

}  // namespace raysweep
