// How far a picture is from another, told.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "tracer/compare.h"

namespace raysweep {

[[nodiscard]] nlohmann::json to_json(const PictureDifference& difference);

/// "RMSE 0.0012, relative MSE …, at most 3 of 255 in a channel, 12 pixels differ in 8 bit, 0 not finite"
[[nodiscard]] std::string to_text(const PictureDifference& difference);

}  // namespace raysweep
