// How often a method is wrong on a case, and by how much where it is right.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "experiments/intersection/case.h"
#include "experiments/intersection/oracle.h"

namespace raysweep {

/// Quantiles of errors; NaN without errors.
struct ErrorSummary {
  size_t count = 0;
  double p50, p99, p999, greatest;
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
  // Of rays with two candidates or more: without any hit though the oracle has one or a boundary; with more
  // hits than the oracle has hits and boundaries.
  size_t missed_rays = 0, extra_rays = 0;
  size_t uncovered_rays = 0;     // that meet no candidate by the oracle either
  std::vector<double> t_error;   // |t − t*| / (ε·|t*|)
  std::vector<double> uv_error;  // max(|β − β*|, |γ − γ*|)
  std::vector<double> difference;  // ‖(O + tD) − P(β, γ)‖∞ / (ε·largest coordinate of O and the corners)
  std::vector<double>
      off_plane;  // distance of O + tD from the plane / (ε·largest coordinate of it and the corners)

  /// One trial; `must_miss` turns every verdict into a miss.
  void count(bool is_hit, Verdict verdict, bool must_miss);
  /// The errors of a finite hit. A t* of 0 has no relative error, and no sample.
  template <class T>
  void measure(const JudgedHit<T>& judged);
  /// One ray with `candidates` of which the method hit `found` and the oracle `expected`.
  void close_ray(size_t candidates, size_t found, size_t expected);

  [[nodiscard]] static ErrorSummary summary(const std::vector<double>& errors);
};

/// What `failures` of `count` rays or trials let expect at most, as a share, at 95 %: 3/n without failures
/// ("rule of three", Hanley & Lippman-Hand 1983). Only for no failures.
[[nodiscard]] constexpr double zero_failures_bound(size_t count) {
  return count == 0 ? 1 : 3 / static_cast<double>(count);
}

/// `method(ray, triangle)` gives an optional TriangleHit; a hit at or beyond the end of its ray is none. All
/// trials that `one` makes of `seed`.
template <class T, class Method>
[[nodiscard]] Tally run_case(const Case& one, double difficulty, uint64_t seed, size_t count,
                             const Method& method) {
  const Trials<T> trials = one.template make<T>(difficulty, seed, count);
  const bool must_miss = one.expectation == Expectation::must_miss;
  Tally tally;
  for (const Trial<T>& trial : trials.rays) {
    size_t found = 0, expected = 0;
    for (const uint32_t i : std::span(trials.candidates).subspan(trial.first, trial.count)) {
      const Triangle<T>& triangle = trials.triangles[i];
      std::optional<TriangleHit<T>> hit = method(trial.ray, triangle);
      if (hit && hit->t >= trial.t_max) hit.reset();
      const Verdict verdict = exact_verdict(trial.ray, triangle, trial.t_max);
      tally.count(hit.has_value(), verdict, must_miss);
      found += hit.has_value();
      expected += verdict != Verdict::miss && !must_miss;
      if (!hit) continue;
      tally.measure(JudgedHit<T>{trial.ray, triangle, *hit, exact_hit(trial.ray, triangle, trial.t_max)});
    }
    tally.close_ray(trial.count, found, expected);
  }
  return tally;
}

}  // namespace raysweep
