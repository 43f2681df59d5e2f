// The rules of claims: pure functions of a group's values.
#pragma once

#include <string>
#include <vector>

namespace raysweep {

/// The largest of the `expected` values by the largest of the `others`: 1 and above, one of those expected is
/// the best. Not for empty lists.
[[nodiscard]] double largest_against(const std::vector<double>& expected, const std::vector<double>& others);

/// The smallest of the `others` by the smallest of the `expected` values: 1 and above as there.
[[nodiscard]] double smallest_against(const std::vector<double>& expected, const std::vector<double>& others);

/// The largest by the smallest; 1 of values that are all 0. Not for an empty list.
[[nodiscard]] double spread(const std::vector<double>& values);

/// The smallest ratio of a value to the next one, largest first; with `smallest_first` of the next one to the
/// value: 1 and above, they are in order. For two values and more.
[[nodiscard]] double least_neighbour_ratio(const std::vector<double>& values, bool smallest_first);

/// The largest |fit − y| / |y| of the line of least squares through the points, or with `intercept` false
/// through the origin too. For as many points as the line has numbers, and more; x must differ.
[[nodiscard]] double largest_residual(const std::vector<double>& x, const std::vector<double>& y,
                                      bool intercept);

}  // namespace raysweep
