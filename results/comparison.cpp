#include "results/comparison.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <numeric>

#include "results/statistics/trimmed_mean.h"

namespace raysweep {

namespace {

constexpr size_t fewest_samples = 6;
constexpr double degrees_share = 0.85;  // see paired_change

/// `variance` is that of the mean; 0 where nearly all samples are the same.
Change change_of(double mean, double variance, double degrees, double confidence, size_t count) {
  Change change{std::exp(mean), {std::exp(mean), std::exp(mean)}, 1, static_cast<int>(count)};
  const double error = std::sqrt(variance);
  if (!(error > 0)) {
    change.p = mean == 0 ? 1 : 0;
    return change;
  }
  const boost::math::students_t student(degrees * degrees_share);
  const double half = quantile(complement(student, (1 - confidence) / 2)) * error;
  change.interval = {std::exp(mean - half), std::exp(mean + half)};
  change.p = 2 * cdf(complement(student, std::abs(mean) / error));
  return change;
}

}  // namespace

std::optional<Change> paired_change(const std::vector<double>& log_ratios, double confidence) {
  if (log_ratios.size() < fewest_samples) return std::nullopt;
  const TrimmedMean t = trimmed_mean(log_ratios);
  return change_of(t.mean, t.variance, t.kept - 1, confidence, log_ratios.size());
}

std::vector<double> log_ratios(const std::map<int, double>& own, const std::map<int, double>& base) {
  std::vector<double> ratios;
  for (const auto& [round, value] : own) {
    if (const auto other = base.find(round); other != base.end())
      ratios.push_back(std::log(value / other->second));
  }
  return ratios;
}

std::optional<Change> unpaired_change(const std::vector<double>& logs, const std::vector<double>& base_logs,
                                      double confidence) {
  const size_t count = std::min(logs.size(), base_logs.size());
  if (count < fewest_samples) return std::nullopt;
  const TrimmedMean a = trimmed_mean(logs), b = trimmed_mean(base_logs);
  const double variance = a.variance + b.variance;
  const double degrees =
      variance * variance / (a.variance * a.variance / (a.kept - 1) + b.variance * b.variance / (b.kept - 1));
  return change_of(a.mean - b.mean, variance, degrees, confidence, count);
}

std::vector<double> holm(const std::vector<double>& p) {
  std::vector<size_t> order(p.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::ranges::stable_sort(order, {}, [&](size_t i) { return p[i]; });
  std::vector<double> adjusted(p.size());
  double largest = 0;
  for (size_t k = 0; k < order.size(); ++k) {
    largest = std::max(largest, std::min(1.0, static_cast<double>(p.size() - k) * p[order[k]]));
    adjusted[order[k]] = largest;
  }
  return adjusted;
}

double simultaneous_confidence(size_t comparisons) {
  return 1 - 0.05 / static_cast<double>(std::max<size_t>(comparisons, 1));
}

bool excludes_one(const Change& change) { return change.interval.low > 1 || change.interval.high < 1; }

Verdict verdict_of(const std::optional<Change>& change, const NoiseFloor& floor) {
  if (!change) return Verdict::too_few;
  if (!excludes_one(*change) || std::abs(std::log(change->ratio)) <= floor.least_effect())
    return Verdict::no_difference;
  return change->ratio > 1 ? Verdict::faster : Verdict::slower;
}

std::string to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::faster:
      return "faster";
    case Verdict::slower:
      return "slower";
    case Verdict::no_difference:
      return "no difference";
    case Verdict::too_few:
      break;
  }
  return "too few";
}

}  // namespace raysweep
