// How far a picture is from another, told.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "tracer/compare.h"
#include "tracer/flip.h"

namespace raysweep {

[[nodiscard]] nlohmann::json to_json(const PictureDifference& difference);

/// "RMSE 0.0012, relative MSE …, at most 3 of 255 in a channel, 12 pixels differ in 8 bit, 5 of
/// them by more than 1, 0 not finite"
[[nodiscard]] std::string to_text(const PictureDifference& difference);

/// Mean, the 95th percentile and the largest value: of most pictures' pixels, most are equal.
[[nodiscard]] nlohmann::json to_json(const FlipMap& map);

/// "FLIP 0.0012 on average, 0.01 at the 95th percentile, 0.2 at most"
[[nodiscard]] std::string to_text(const FlipMap& map);

}  // namespace raysweep
