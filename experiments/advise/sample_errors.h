// How far from the true point a scene's hits are: by the laws of rounding, and by the exact oracle.
#pragma once

#include <limits>
#include <string_view>
#include <vector>

#include "experiments/advise/hit_sample.h"

namespace raysweep {

/// Errors of hit points are told as the one that all but one hit in a thousand keep.
inline constexpr double kept_share = 0.999;

/// The least of `errors` that the share `kept_share` of them does not exceed; infinite ones are among them. 0
/// without errors.
[[nodiscard]] double kept_error(std::vector<double> errors);

/// From a bound of each hit's error (`error_bounds.h`), in scene units; infinite where nothing can be
/// promised. `method` is one of the study, `precision` float or double. Throws std::out_of_range for others.
[[nodiscard]] double predicted_error(std::string_view method, std::string_view precision,
                                     const std::vector<SampledHit>& hits);

/// What a method did with hits that the oracle has.
struct Measurement {
  double error = 0;   // in scene units
  size_t missed = 0;  // found no hit where the oracle has one
  /// What `error` is at most, at 95 %, as if hits were drawn at random from all that the scene has; those
  /// missed are among them and err without bound. Infinite where there are too few to tell.
  double shown = std::numeric_limits<double>::infinity();
};

/// Of the errors of some hits what all but one in a thousand of all keep, at 95 %. 0 without errors.
[[nodiscard]] double shown_error(std::vector<double> errors);

/// Of the tracer's methods as it renders with them, of the study's others in their base variants; else as
/// `predicted_error`.
[[nodiscard]] Measurement measured_error(std::string_view method, std::string_view precision,
                                         const std::vector<SampledHit>& hits);

}  // namespace raysweep
