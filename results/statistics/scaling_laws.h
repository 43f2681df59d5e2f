// Laws that a scaling curve may follow, fitted: Amdahl's, and Gunther's Universal Scalability Law.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/statistics/statistics.h"

namespace raysweep {

struct ScalingPoint {
  int threads;
  double fps;
};

/// Karp & Flatt 1990: the serial share that would explain this speedup, (1/S − 1/p)/(1 − 1/p). Negative where
/// the speedup exceeds p. None for one thread.
[[nodiscard]] std::optional<double> karp_flatt(double speedup, int threads);

/// The same of an interval; it turns round, as more speedup is less of a serial share.
[[nodiscard]] std::optional<Estimate> karp_flatt(const std::optional<Estimate>& speedup, int threads);

/// X(N) = λN/(1 + σ(N − 1) + κN(N − 1)) (Gunther 2007, "Guerrilla Capacity Planning"), fitted to log fps by
/// least squares. Intervals are 95 %, from the Jacobian at the minimum and Student's quantile with n − k
/// degrees of freedom: they take errors of log fps for equal, normal and independent.
struct ScalingLaw {
  double fps_of_one = 0;               // λ
  Estimate serial_share;               // σ: waiting for each other; Amdahl's serial share where κ is 0
  std::optional<Estimate> coherence;   // κ: agreeing with each other; none in Amdahl's law
  std::optional<double> peak_threads;  // √((1 − σ)/κ), where κ is shown to be above 0
  bool extrapolated = false;           // that peak lies beyond what was measured
  bool superlinear = false;            // σ or κ is shown to be negative: more threads make a thread faster
  double residual = 0;                 // standard deviation of log fps around the curve
};

struct ScalingLaws {
  int points = 0;  // different thread counts up to the physical cores
  std::optional<ScalingLaw> amdahl, usl;
  std::string refused;  // why there are none
};

inline constexpr int fewest_thread_counts = 6;

/// Points above `cores` are another regime (hyper-threads, oversubscription) and left out; of several points
/// with the same number of threads all count. Refused with fewer than 6 different thread counts in the rest.
[[nodiscard]] ScalingLaws fit_scaling_laws(std::vector<ScalingPoint> points, int cores);

}  // namespace raysweep
