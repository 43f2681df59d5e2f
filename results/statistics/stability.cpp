#include "results/statistics/stability.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <map>
#include <numeric>

#include "results/statistics/random.h"
#include "results/statistics/statistics.h"

namespace raysweep {

namespace {

/// P(at most `inversions` pairs out of order) in a random order of n: the counts of Kendall's statistic,
/// built up sample by sample.
double inversions_at_most(int n, int inversions) {
  std::vector<double> chance{1};
  for (int k = 2; k <= n; ++k) {  // sample k passes 0 to k − 1 others, each equally likely
    std::vector<double> next(chance.size() + static_cast<size_t>(k) - 1);
    for (size_t i = 0; i < chance.size(); ++i) {
      for (size_t passed = 0; passed < static_cast<size_t>(k); ++passed) next[i + passed] += chance[i] / k;
    }
    chance = std::move(next);
  }
  return std::accumulate(chance.begin(), chance.begin() + inversions + 1, 0.0);
}

/// The variance of Kendall's S, less what ties take (Kendall 1975, 4.9).
double variance_of_s(const std::vector<double>& series) {
  const auto term = [](double n) { return n * (n - 1) * (2 * n + 5) / 18; };
  std::map<double, int> groups;
  for (const double x : series) groups[x]++;
  double variance = term(static_cast<double>(series.size()));
  for (const auto& [value, count] : groups) variance -= term(count);
  return variance;
}

/// `s`: pairs that rise less pairs that fall.
double mann_kendall_p(const std::vector<double>& series, int s, bool ties) {
  constexpr int most_exact = 50;
  const int n = static_cast<int>(series.size());
  if (s == 0) return 1;
  if (!ties && n <= most_exact) {
    const int pairs = n * (n - 1) / 2;
    return std::min(1.0, 2 * inversions_at_most(n, (pairs - std::abs(s)) / 2));
  }
  const double z = (std::abs(s) - 1) / std::sqrt(variance_of_s(series));  // corrected for continuity
  return 2 * cdf(complement(boost::math::normal(), z));
}

double lag_one(const std::vector<double>& deviations) {
  double products = 0, squares = 0;
  for (size_t i = 0; i < deviations.size(); ++i) {
    squares += deviations[i] * deviations[i];
    if (i > 0) products += deviations[i - 1] * deviations[i];
  }
  return products / squares;
}

}  // namespace

std::optional<SeriesTest> drift(const std::vector<double>& series) {
  const size_t n = series.size();
  if (n < fewest_for_drift) return std::nullopt;
  std::vector<double> slopes;
  int s = 0;
  bool ties = false;
  for (size_t i = 0; i < n; ++i) {
    for (size_t j = i + 1; j < n; ++j) {
      const double rise = series[j] - series[i];
      slopes.push_back(rise / static_cast<double>(j - i));
      s += (rise > 0) - (rise < 0);
      ties |= rise == 0;
    }
  }
  const double total = median(std::move(slopes)) * static_cast<double>(n - 1);
  return SeriesTest{total / std::abs(median(series)), mann_kendall_p(series, s, ties)};
}

std::optional<SeriesTest> autocorrelation(const std::vector<double>& series) {
  constexpr int orders = 2000;
  const size_t n = series.size();
  if (n < fewest_for_autocorrelation) return std::nullopt;
  const double mean = std::accumulate(series.begin(), series.end(), 0.0) / static_cast<double>(n);
  std::vector<double> deviations;
  for (const double x : series) deviations.push_back(x - mean);
  if (std::ranges::all_of(series, [&](double x) { return x == series.front(); })) return std::nullopt;

  const double seen = lag_one(deviations);
  Random random(1);
  int as_large = 1;  // the order that was seen is one of those that chance could give
  for (int i = 0; i < orders; ++i) {
    for (size_t k = n; k > 1; --k) std::swap(deviations[k - 1], deviations[random.index(k)]);
    as_large += lag_one(deviations) >= seen;
  }
  return SeriesTest{seen, static_cast<double>(as_large) / (orders + 1)};
}

std::vector<std::string> stability_warnings(const std::vector<double>& series) {
  if (const auto found = drift(series); found && found->p < false_alarm_rate) {
    return {fmt::format("drifts by {}{:.1f} % over the run: the interval is too narrow for what comes later",
                        found->size < 0 ? "−" : "+", std::abs(found->size) * 100)};
  }
  if (const auto found = autocorrelation(series); found && found->p < false_alarm_rate) {
    return {fmt::format(
        "launches resemble those before them (lag-1 correlation {:.2f}): the interval is too narrow",
        found->size)};
  }
  return {};
}

}  // namespace raysweep
