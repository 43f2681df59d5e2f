// Trials with what is true of them: decided once, for all methods that are to be judged by it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "experiments/intersection/case.h"
#include "experiments/intersection/oracle.h"

namespace raysweep {

/// What a method says of each of a batch's candidates, in the order of `Trials::candidates`.
template <class T>
using Hits = std::vector<std::optional<TriangleHit<T>>>;

/// `test(trial, triangle)` of each ray and the index of each of its candidates.
template <class T, class Test>
[[nodiscard]] Hits<T> hits_of(const Trials<T>& trials, const Test& test) {
  Hits<T> hits(trials.candidates.size());
  for (const Trial<T>& trial : trials.rays) {
    for (size_t i = trial.first; i < trial.first + trial.count; ++i)
      hits[i] = test(trial, trials.candidates[i]);
  }
  return hits;
}

/// All trials of one case at one difficulty.
template <class T>
struct JudgedTrials {
  Trials<T> trials;
  std::vector<ExactHit> exact;  // in the order of `Trials::candidates`; of a miss there is nothing but that
  bool must_miss;               // every verdict counts as a miss

  JudgedTrials(const Case& one, double difficulty, uint64_t seed, size_t count);
};

}  // namespace raysweep
