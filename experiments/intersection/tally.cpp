#include "experiments/intersection/tally.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace raysweep {

namespace {

using Wide = Vec3<long double>;

template <class T>
Wide point_of(const Triangle<T>& triangle, const TriangleHit<T>& hit) {
  const Wide a(triangle.a), b(triangle.b), c(triangle.c);
  const long double beta = hit.beta, gamma = hit.gamma;
  return a + (b - a) * beta + (c - a) * gamma;
}

double as_double(long double error) {
  return static_cast<double>(std::min(error, static_cast<long double>(std::numeric_limits<double>::max())));
}

}  // namespace

void Tally::count(bool is_hit, ExactVerdict verdict, bool must_miss) {
  ++trials;
  if (must_miss) verdict = ExactVerdict::miss;
  hits += verdict == ExactVerdict::hit;
  boundary += verdict == ExactVerdict::boundary;
  false_hits += is_hit && verdict == ExactVerdict::miss;
  false_misses += !is_hit && verdict == ExactVerdict::hit;
}

template <class T>
void Tally::measure(const JudgedHit<T>& judged, Output output) {
  if (output == Output::hit) return;
  const auto& [ray, triangle, hit, exact] = judged;
  const bool has_weights = output == Output::weights;
  if (!std::isfinite(hit.t) || (has_weights && !(std::isfinite(hit.beta) && std::isfinite(hit.gamma)))) {
    ++nonfinite;
    return;
  }
  if (exact.verdict == ExactVerdict::miss || std::isnan(exact.t)) return;
  const long double epsilon = std::numeric_limits<T>::epsilon();
  const long double of_t = std::abs(hit.t - exact.t);
  if (exact.t != 0) t_error.push_back(as_double(of_t / (epsilon * std::abs(exact.t))));
  const Wide along = Wide(ray.origin) + Wide(ray.direction) * static_cast<long double>(hit.t);
  const T corners = std::max({max_abs(triangle.a), max_abs(triangle.b), max_abs(triangle.c)});
  // The point was on the plane at t*, and leaves it by `rise` for each 1 of t.
  const long double place = std::max(max_abs(along), static_cast<long double>(corners));
  if (place > 0) off_plane.push_back(as_double(of_t * exact.rise / (epsilon * place)));
  if (!has_weights) return;
  const long double of_beta = std::abs(hit.beta - exact.beta), of_gamma = std::abs(hit.gamma - exact.gamma);
  uv_error.push_back(as_double(std::max(of_beta, of_gamma)));
  if (exact.beta != 0) weight_error.push_back(as_double(of_beta / (epsilon * std::abs(exact.beta))));
  if (exact.gamma != 0) weight_error.push_back(as_double(of_gamma / (epsilon * std::abs(exact.gamma))));
  const long double of_difference = max_abs(along - point_of(triangle, hit));
  difference.push_back(as_double(of_difference / (epsilon * std::max(corners, max_abs(ray.origin)))));
}

void Tally::close_ray(size_t candidates, size_t found, size_t expected) {
  ++rays;
  if (candidates < 2) return;
  ++mesh_rays;
  missed_rays += found == 0 && expected > 0;
  extra_rays += found > expected;
  uncovered_rays += expected == 0;
}

ErrorSummary Tally::summary(const std::vector<double>& errors) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (errors.empty()) return {0, nan, nan, nan, nan, nan};
  // Errors may be as great as doubles get: their sum is not one.
  const long double sum = std::accumulate(errors.begin(), errors.end(), 0.0L);
  const double mean = as_double(sum / static_cast<long double>(errors.size()));
  return {errors.size(),           quantile(errors, 0.5), quantile(errors, 0.99),
          quantile(errors, 0.999), quantile(errors, 1),   mean};
}

template <class T>
bool picks_other(const Trial<T>& trial, const Hits<T>& hits, const std::vector<ExactHit>& exact) {
  const size_t end = trial.first + trial.count;
  size_t nearest = end;
  bool is_open = false, has_hit = false;
  T least = std::numeric_limits<T>::infinity();
  for (size_t i = trial.first; i < end; ++i) {
    if (hits[i]) {
      has_hit = true;
      least = std::min(least, hits[i]->t);
    }
    if (exact[i].verdict == ExactVerdict::boundary) return false;
    if (exact[i].verdict == ExactVerdict::miss) continue;
    if (nearest == end || exact[i].t < exact[nearest].t) {
      nearest = i;
      is_open = false;
    } else if (exact[i].t == exact[nearest].t) {
      is_open = true;
    }
  }
  if (is_open) return false;
  if (nearest == end) return has_hit;
  return !hits[nearest] || hits[nearest]->t > least;
}

template bool picks_other(const Trial<float>&, const Hits<float>&, const std::vector<ExactHit>&);
template bool picks_other(const Trial<double>&, const Hits<double>&, const std::vector<ExactHit>&);

template <class T>
Tally tally_of(const JudgedTrials<T>& judged, const Hits<T>& hits, Output output) {
  const auto& [trials, exact, must_miss] = judged;
  Tally tally;
  for (const Trial<T>& trial : trials.rays) {
    size_t found = 0, expected = 0;
    for (size_t i = trial.first; i < trial.first + trial.count; ++i) {
      const ExactVerdict verdict = exact[i].verdict;
      tally.count(hits[i].has_value(), verdict, must_miss);
      found += hits[i].has_value();
      expected += verdict != ExactVerdict::miss && !must_miss;
      if (!hits[i]) continue;
      const Triangle<T>& triangle = trials.triangles[trials.candidates[i]];
      tally.measure(JudgedHit<T>{trial.ray, triangle, *hits[i], exact[i]}, output);
    }
    tally.close_ray(trial.count, found, expected);
    if (trial.count > 1 && output != Output::hit && !must_miss)
      tally.other_nearest += picks_other(trial, hits, exact);
  }
  return tally;
}

template Tally tally_of(const JudgedTrials<float>&, const Hits<float>&, Output);
template Tally tally_of(const JudgedTrials<double>&, const Hits<double>&, Output);

}  // namespace raysweep
