// Laws of error against what methods did, hit by hit.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "experiments/advise/error_bounds.h"
#include "experiments/intersection/subjects.h"
#include "tracer/intersect/study.h"

namespace raysweep {

/// How many hits have been held against a law.
struct LawCheck {
  size_t hits = 0, broken = 0;
};

/// The oracle's values are right to 60 bits.
inline bool keeps(long double value, long double exact, long double bound) {
  return std::abs(value - exact) <= bound + 0x1p-60L * std::abs(exact);
}

template <class T>
bool keeps_law(const Ray<T>& ray, const Triangle<T>& triangle, const TriangleHit<T>& hit,
               const ExactHit& exact, const HitBound& bound) {
  if (!keeps(hit.t, exact.t, bound.t)) return false;
  const long double of_point = point_error(ray, triangle, hit, exact.t, exact.beta, exact.gamma);
  // The error is a difference of coordinates and weights that the oracle rounds.
  const long double of_oracle = 0x1p-60L * (std::abs(exact.t) * length(Vec3<long double>(ray.direction)) +
                                            length(Vec3<long double>(triangle.b - triangle.a)) +
                                            length(Vec3<long double>(triangle.c - triangle.a)));
  if (!(of_point <= bound.point + of_oracle)) return false;
  return std::isnan(hit.beta) ||
         (keeps(hit.beta, exact.beta, bound.beta) && keeps(hit.gamma, exact.gamma, bound.gamma));
}

/// All hits of `hits` that the oracle has, too.
template <class T>
void check_law(std::string_view method, const JudgedTrials<T>& judged, const Hits<T>& hits, LawCheck& check) {
  const ErrorLaw<T>& law = error_law_of<T>(method);
  for (const Trial<T>& trial : judged.trials.rays) {
    for (size_t i = trial.first; i < trial.first + trial.count; ++i) {
      const ExactHit& exact = judged.exact[i];
      if (!hits[i] || exact.verdict == ExactVerdict::miss || std::isnan(exact.t)) continue;
      const Triangle<T>& triangle = judged.trials.triangles[judged.trials.candidates[i]];
      ++check.hits;
      check.broken += !keeps_law(trial.ray, triangle, *hits[i], exact, law.bound(trial.ray, triangle));
    }
  }
}

/// Every case of the catalogue at every difficulty, `ray_count` rays each: every method of the study in its
/// base variant, and the tracer's as they render.
template <class T>
LawCheck check_all_laws(size_t ray_count) {
  LawCheck all;
  for (const Case& one : all_cases()) {
    for (const double difficulty : one.difficulties) {
      const JudgedTrials<T> judged(one, difficulty, 11, ray_count);
      const auto check = [&](std::string_view method, const char* how, const Hits<T>& hits) {
        LawCheck check;
        check_law(method, judged, hits, check);
        EXPECT_EQ(check.broken, 0u) << method << how << ", case " << one.id << " at " << difficulty << ": of "
                                    << check.hits << " hits so many err by more than their law says";
        all.hits += check.hits;
      };
      for (const Subject<T>& subject : all_subjects<T>())
        if (subject.change == "base") check(subject.method, "", subject.find_hits(judged.trials));
      for_each_study_method([&]<class Method>(Method) {
        if constexpr (Intersector<Method, T>) {
          check(Method::name, " as rendered",
                hits_of(judged.trials, [&](const Trial<T>& trial, uint32_t triangle) {
                  return Method::intersect(trial.ray, Method::prepare(judged.trials.triangles[triangle]));
                }));
        }
      });
    }
  }
  return all;
}

}  // namespace raysweep
