// How often a method is wrong on a case, and by how much where it is right.
#pragma once

#include <vector>

#include "experiments/intersection/judged.h"
#include "results/statistics/statistics.h"
#include "tracer/intersect/variant.h"

namespace raysweep {

/// Quantiles of errors, and their mean; NaN without errors.
struct ErrorSummary {
  size_t count = 0;
  double p50, p99, p999, greatest, mean;
};

/// One hit, as the method and the oracle have it.
template <class T>
struct JudgedHit {
  Ray<T> ray;
  Triangle<T> triangle;
  TriangleHit<T> hit;
  ExactHit exact;
};

/// What a method did in one case at one difficulty. ε is the distance from 1 to the next number of T. Errors
/// are of hits that the oracle has, too, boundaries included.
struct Tally {
  size_t rays = 0, trials = 0;  // a trial is one ray with one triangle
  // Of trials, by the oracle; of cases whose rays must miss no trial counts as a hit or a boundary.
  size_t hits = 0, boundary = 0;
  size_t false_hits = 0, false_misses = 0;
  size_t nonfinite = 0;  // hits with a number that is infinite or NaN
  size_t mesh_rays = 0;  // with two candidates or more; the following are of them
  // Without any hit though the oracle has one or a boundary; with more hits than the oracle has hits and
  // boundaries.
  size_t missed_rays = 0, extra_rays = 0;
  size_t uncovered_rays = 0;         // that meet no candidate by the oracle either
  size_t other_nearest = 0;          // whose nearest hit is not the oracle's: see `picks_other`
  std::vector<double> t_error;       // |t − t*| / (ε·|t*|)
  std::vector<double> uv_error;      // max(|β − β*|, |γ − γ*|)
  std::vector<double> weight_error;  // |β − β*| / (ε·|β*|), then of γ
  std::vector<double> difference;  // ‖(O + tD) − P(β, γ)‖∞ / (ε·largest coordinate of O and the corners)
  std::vector<double>
      off_plane;  // distance of O + tD from the plane / (ε·largest coordinate of it and the corners)

  /// One trial; `must_miss` turns every verdict into a miss.
  void count(bool is_hit, ExactVerdict verdict, bool must_miss);
  /// The errors of a finite hit, of which the method gave what `output` says. A t* of 0 has no relative
  /// error, and no sample. Errors beyond the greatest double count as that.
  template <class T>
  void measure(const JudgedHit<T>& judged, Output output);
  /// One ray with `candidates` of which the method hit `found` and the oracle `expected`.
  void close_ray(size_t candidates, size_t found, size_t expected);

  [[nodiscard]] static ErrorSummary summary(const std::vector<double>& errors);
};

/// Whether the nearest of a ray's `hits` is none of the oracle's nearest, or one of both has no hit. False
/// where the oracle leaves it open: at a boundary, and between hits at the same t.
template <class T>
[[nodiscard]] bool picks_other(const Trial<T>& trial, const Hits<T>& hits,
                               const std::vector<ExactHit>& exact);

/// What a method did that had `hits` on `judged` trials. Of its hits it gave what `output` says.
template <class T>
[[nodiscard]] Tally tally_of(const JudgedTrials<T>& judged, const Hits<T>& hits, Output output);

/// Of one method alone: `method(ray, triangle)` gives an optional TriangleHit; a hit at or beyond the end of
/// its ray is none; of its numbers `output` tells which count. All trials that `one` makes of `seed`.
template <class T, class Method>
[[nodiscard]] Tally run_case(const Case& one, double difficulty, uint64_t seed, size_t count,
                             const Method& method, Output output = Output::weights) {
  const JudgedTrials<T> judged(one, difficulty, seed, count);
  const Hits<T> hits = hits_of(judged.trials, [&](const Trial<T>& trial, uint32_t triangle) {
    std::optional<TriangleHit<T>> hit = method(trial.ray, judged.trials.triangles[triangle]);
    if (hit && hit->t >= trial.t_max) hit.reset();
    return hit;
  });
  return tally_of(judged, hits, output);
}

}  // namespace raysweep
