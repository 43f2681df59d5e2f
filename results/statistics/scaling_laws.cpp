#include "results/statistics/scaling_laws.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <set>

namespace raysweep {

namespace {

/// A parameter is negative from here on: what is nearer to 0 is the rounding of an exact curve.
constexpr double negative = -1e-6;

/// log λ and σ, and κ where there are three.
using Parameters = Eigen::VectorXd;

double contention(const Parameters& at, double n) {
  return at[1] * (n - 1) + (at.size() > 2 ? at[2] * n * (n - 1) : 0);
}

/// Measured less fitted log fps; not finite where the law gives no positive fps.
Eigen::VectorXd residuals(const std::vector<ScalingPoint>& points, const Parameters& at) {
  Eigen::VectorXd r(static_cast<Eigen::Index>(points.size()));
  for (Eigen::Index i = 0; i < r.size(); ++i) {
    const auto& [threads, fps] = points[static_cast<size_t>(i)];
    r[i] = std::log(fps) - at[0] - std::log(threads) + std::log(1 + contention(at, threads));
  }
  return r;
}

/// Of the fitted log fps by the parameters.
Eigen::MatrixXd jacobian(const std::vector<ScalingPoint>& points, const Parameters& at) {
  Eigen::MatrixXd j(static_cast<Eigen::Index>(points.size()), at.size());
  for (Eigen::Index i = 0; i < j.rows(); ++i) {
    const double n = points[static_cast<size_t>(i)].threads;
    const double below = 1 + contention(at, n);
    j(i, 0) = 1;
    j(i, 1) = -(n - 1) / below;
    if (at.size() > 2) j(i, 2) = -n * (n - 1) / below;
  }
  return j;
}

/// The linear fit of N/X = (1 + σ(N − 1) + κN(N − 1))/λ: near enough to start from.
Parameters starting_point(const std::vector<ScalingPoint>& points, int parameters) {
  Eigen::MatrixXd a(static_cast<Eigen::Index>(points.size()), parameters);
  Eigen::VectorXd b(a.rows());
  for (Eigen::Index i = 0; i < a.rows(); ++i) {
    const auto& [threads, fps] = points[static_cast<size_t>(i)];
    const double n = threads;
    b[i] = n / fps;
    a(i, 0) = 1;
    a(i, 1) = n - 1;
    if (parameters > 2) a(i, 2) = n * (n - 1);
  }
  const Eigen::VectorXd linear = a.colPivHouseholderQr().solve(b);
  Parameters start = linear / linear[0];
  start[0] = -std::log(linear[0]);
  if (residuals(points, start).allFinite()) return start;
  start.setZero();  // a curve so far from any law starts from the straight line
  start[0] = std::log(points.front().fps / points.front().threads);
  return start;
}

/// Levenberg 1944, Marquardt 1963: Gauss–Newton, damped until a step makes the squares less.
Parameters least_squares(const std::vector<ScalingPoint>& points, Parameters at) {
  constexpr int most_steps = 200;
  double damping = 1e-6;
  Eigen::VectorXd r = residuals(points, at);
  for (int step = 0; step < most_steps && damping < 1e12; ++step) {
    const Eigen::MatrixXd j = jacobian(points, at);
    Eigen::MatrixXd normal = j.transpose() * j;
    normal.diagonal() *= 1 + damping;
    const Parameters change = normal.ldlt().solve(j.transpose() * r);
    const Parameters next = at + change;
    const Eigen::VectorXd next_r = residuals(points, next);
    if (!next_r.allFinite() || next_r.squaredNorm() > r.squaredNorm()) {
      damping *= 10;
      continue;
    }
    at = next;
    r = next_r;
    damping /= 10;
    if (change.norm() < 1e-13) break;
  }
  return at;
}

ScalingLaw fit(const std::vector<ScalingPoint>& points, int parameters) {
  const Parameters at = least_squares(points, starting_point(points, parameters));
  const Eigen::MatrixXd j = jacobian(points, at);
  const double degrees = static_cast<double>(points.size()) - parameters;
  const double variance = residuals(points, at).squaredNorm() / degrees;
  const Eigen::MatrixXd covariance = variance * (j.transpose() * j).inverse();
  const double t = quantile(boost::math::students_t(degrees), 0.975);
  const auto estimate = [&](Eigen::Index i) {
    const double half = t * std::sqrt(covariance(i, i));
    return Estimate{at[i], Estimate::Bounds{at[i] - half, at[i] + half}, static_cast<int>(points.size())};
  };
  ScalingLaw law;
  law.fps_of_one = std::exp(at[0]);
  law.serial_share = estimate(1);
  law.superlinear = law.serial_share.interval->high < negative;
  law.residual = std::sqrt(variance);
  if (parameters < 3) return law;
  law.coherence = estimate(2);
  law.superlinear |= law.coherence->interval->high < negative;
  if (law.coherence->interval->low > 0 && at[1] < 1) law.peak_threads = std::sqrt((1 - at[1]) / at[2]);
  const auto most = std::ranges::max_element(points, {}, &ScalingPoint::threads);
  law.extrapolated = law.peak_threads && *law.peak_threads > most->threads;
  return law;
}

}  // namespace

std::optional<double> karp_flatt(double speedup, int threads) {
  if (threads < 2) return std::nullopt;
  return (1 / speedup - 1.0 / threads) / (1 - 1.0 / threads);
}

std::optional<Estimate> karp_flatt(const std::optional<Estimate>& speedup, int threads) {
  if (!speedup || threads < 2) return std::nullopt;
  Estimate e{*karp_flatt(speedup->value, threads), std::nullopt, speedup->count};
  if (speedup->interval) {
    const auto [low, high] = *speedup->interval;
    e.interval = {*karp_flatt(high, threads), *karp_flatt(low, threads)};
  }
  return e;
}

ScalingLaws fit_scaling_laws(std::vector<ScalingPoint> points, int cores) {
  std::erase_if(points, [&](const ScalingPoint& p) { return p.threads > cores || !(p.fps > 0); });
  std::set<int> counts;
  for (const ScalingPoint& p : points) counts.insert(p.threads);
  ScalingLaws laws;
  laws.points = static_cast<int>(counts.size());
  if (laws.points < fewest_thread_counts) {
    laws.refused = fmt::format("not fitted: {} thread count{} up to {} cores, {} are needed", laws.points,
                               laws.points == 1 ? "" : "s", cores, fewest_thread_counts);
    return laws;
  }
  laws.amdahl = fit(points, 2);
  laws.usl = fit(points, 3);
  return laws;
}

}  // namespace raysweep
