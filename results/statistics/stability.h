// Whether launches, in the order of their rounds, are what intervals take them for: independent, and all
// alike.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace raysweep {

/// A test of a series against chance.
struct SeriesTest {
  double size = 0;  // of what was looked for
  double p = 1;     // of as much by chance
};

/// Both checks warn where chance does so once in a hundred stable series.
inline constexpr double false_alarm_rate = 0.01;
inline constexpr size_t fewest_for_drift = 6;             // p can go down to 2/6! = 0.003
inline constexpr size_t fewest_for_autocorrelation = 10;  // fewer show only correlations that drift explains

/// Drift from first to last: the Theil–Sen slope (the median of all slopes between two samples; Sen 1968)
/// times n − 1, relative to the median. p is Mann–Kendall's, two-sided (Kendall 1975): exact without ties up
/// to 50 samples, else normal with the variance corrected for ties. Neither minds odd launches. None below 6
/// samples. The series must have a median other than 0.
[[nodiscard]] std::optional<SeriesTest> drift(const std::vector<double>& series);

/// r₁ = Σ (xᵢ − m)(xᵢ₊₁ − m) / Σ (xᵢ − m)² with the mean m. p is the share of 2,000 random orders whose r₁ is
/// as large or larger (one-sided: it is positive correlation that makes intervals too narrow), which is exact
/// for any distribution. None below 10 samples, or where all are equal.
[[nodiscard]] std::optional<SeriesTest> autocorrelation(const std::vector<double>& series);

/// What a reader of the interval must know, as sentences; empty where the assumptions hold. Where a series
/// drifts, its correlation is that of the drift and not mentioned. There is no test for several modes: with 7
/// to 30 launches none that is worth its false alarms finds a second mode that an interval of the median
/// minds.
[[nodiscard]] std::vector<std::string> stability_warnings(const std::vector<double>& series);

}  // namespace raysweep
