#include "experiments/intersection/judged.h"

namespace raysweep {

template <class T>
JudgedTrials<T>::JudgedTrials(const Case& one, double difficulty, uint64_t seed, size_t count)
    : trials(one.make<T>(difficulty, seed, count)),
      exact(trials.candidates.size()),
      must_miss(one.expectation == Expectation::must_miss) {
  for (const Trial<T>& trial : trials.rays) {
    for (size_t i = trial.first; i < trial.first + trial.count; ++i) {
      const Triangle<T>& triangle = trials.triangles[trials.candidates[i]];
      // Most are misses, which the verdict alone tells sooner.
      if (exact_verdict(trial.ray, triangle, trial.t_max) != ExactVerdict::miss)
        exact[i] = exact_hit(trial.ray, triangle, trial.t_max);
    }
  }
}

template struct JudgedTrials<float>;
template struct JudgedTrials<double>;

}  // namespace raysweep
