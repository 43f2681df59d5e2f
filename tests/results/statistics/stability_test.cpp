#include "results/statistics/stability.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/results/statistics/simulated.h"

namespace raysweep {
namespace {

/// SciPy 1.10.1: scipy.stats.kendalltau(range(8), x, method='exact').pvalue, theilslopes(x, range(10)).slope.
TEST(drift, is_that_of_scipy) {
  EXPECT_NEAR(drift({5, 3, 6, 8, 7, 9, 12, 10})->p, 0.005505952380952381, 1e-12);
  const auto test = drift({1.0, 1.2, 0.9, 1.4, 1.5, 1.3, 1.8, 1.7, 1.6, 2.0});
  EXPECT_NEAR(test->size, 0.1 * 9 / 1.45, 1e-12);
  EXPECT_NEAR(test->p, 0.00468694885361552, 1e-12);
}

TEST(drift, has_an_approximation_where_samples_are_equal) {
  EXPECT_EQ(drift(std::vector<double>(7, 1.0))->p, 1);
  EXPECT_LT(drift({1, 1, 2, 2, 3, 3, 4, 4})->p, 0.01);
}

/// r₁ by hand: deviations ∓½, so that each product is −¼ and the squares add up to n/4.
TEST(autocorrelation, is_that_of_its_formula) {
  std::vector<double> series(10);
  for (size_t i = 0; i < series.size(); ++i) series[i] = i % 2 ? 1 : 2;
  EXPECT_NEAR(autocorrelation(series)->size, -0.9, 1e-12);
  EXPECT_GT(autocorrelation(series)->p, 0.99);
  EXPECT_FALSE(autocorrelation(std::vector<double>(10, 1.0))) << "nothing varies";
}

TEST(stability, has_minimum_counts) {
  EXPECT_FALSE(drift({1, 2, 3, 4, 5}));
  EXPECT_TRUE(drift({1, 2, 3, 4, 5, 6}));
  EXPECT_FALSE(autocorrelation({1, 2, 3, 4, 5, 6, 7, 8, 9}));
  EXPECT_TRUE(autocorrelation({1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
  EXPECT_TRUE(stability_warnings({1, 2, 3}).empty());
}

/// The share of series of log fps around 1 for which `check` fires.
template <class Draw, class Check>
double rate(int n, int trials, Draw&& draw, Check&& check) {
  int fired = 0;
  for (int i = 0; i < trials; ++i) {
    std::vector<double> series(static_cast<size_t>(n));
    double before = 0;
    for (int k = 0; k < n; ++k) series[static_cast<size_t>(k)] = 1 + (before = draw(k, before));
    fired += check(series);
  }
  return fired / double(trials);
}

bool drifts(const std::vector<double>& series) { return drift(series)->p < false_alarm_rate; }
bool correlates(const std::vector<double>& series) { return autocorrelation(series)->p < false_alarm_rate; }

TEST(stability, is_silent_on_99_of_100_stable_series) {
  double correlated = 0;
  for (const std::string& kind : simulated_kinds) {
    Simulated draw(kind);
    const auto stable = [&](int, double) { return draw(); };
    for (const int n : {6, 7, 14, 30}) EXPECT_LE(rate(n, 2000, stable, drifts), 0.0156) << kind << n;
    correlated += rate(14, 500, stable, correlates) / 4;
  }
  RecordProperty("correlated", std::to_string(correlated));
  EXPECT_LE(correlated, 0.01 + 2.5 * std::sqrt(0.01 * 0.99 / 2000));
}

TEST(stability, warns_of_launches_that_resemble_those_before) {
  Simulated draw("normal");
  const auto resembling = [&](int, double before) { return 0.8 * before + draw(); };
  const double found =
      rate(30, 300, resembling, [](const auto& series) { return !stability_warnings(series).empty(); });
  RecordProperty("found", std::to_string(found));
  EXPECT_GE(found, 0.9) << "ρ = 0.8, 30 launches";
}

TEST(stability, warns_of_drift) {
  Simulated draw("normal");  // 2 %
  const auto drifting = [&](int k, double) { return 0.05 * k / 29 + draw(); };
  const double found = rate(30, 1000, drifting, drifts);
  RecordProperty("found", std::to_string(found));
  EXPECT_GE(found, 0.8) << "by 5 % over 30 launches";
}

TEST(stability, says_what_it_found) {
  std::vector<double> rising, waving;
  for (int k = 0; k < 15; ++k) rising.push_back(1 + 0.003 * k);
  EXPECT_EQ(stability_warnings(rising).at(0),
            "drifts by +4.1 % over the run: the interval is too narrow for what comes later");
  for (double& x : rising) x = 2 - x;
  EXPECT_EQ(stability_warnings(rising).at(0),
            "drifts by −4.3 % over the run: the interval is too narrow for what comes later");
  for (int k = 0; k < 30; ++k) waving.push_back(10 + std::sin(k * 0.42));
  const auto said = stability_warnings(waving);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_TRUE(said[0].starts_with("launches resemble those before them (lag-1 correlation 0.")) << said[0];
}

}  // namespace
}  // namespace raysweep
