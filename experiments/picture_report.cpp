#include "experiments/picture_report.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace raysweep {

namespace {

/// NaN: no pixel was finite in both pictures.
std::string number_or_unknown(double value) {
  return std::isfinite(value) ? fmt::format("{:.3g}", value) : "unknown";
}

}  // namespace

nlohmann::json to_json(const PictureDifference& d) {
  nlohmann::json json{{"rmse", d.rmse},
                      {"relative_mse", d.relative_mse},
                      {"max_8bit", d.max_8bit},
                      {"differing_pixels", d.differing_pixels},
                      {"wrong_pixels", d.wrong_pixels},
                      {"non_finite", d.non_finite}};
  if (d.hits_known) {
    json["differing_hits"] = d.differing_hits;
    json["holes"] = d.holes;
  }
  return json;
}

std::string to_text(const PictureDifference& d) {
  std::string text = fmt::format(
      "RMSE {}, relative MSE {}, at most {} of 255 in a channel, {} pixels differ in 8 bit, {} of them "
      "by more than {}, {} not finite",
      number_or_unknown(d.rmse), number_or_unknown(d.relative_mse), d.max_8bit, d.differing_pixels,
      d.wrong_pixels, tolerated_8bit, d.non_finite);
  if (d.hits_known)
    text += fmt::format(", {} see another primitive, {} of them nothing where there is one", d.differing_hits,
                        d.holes);
  return text;
}

nlohmann::json to_json(const FlipMap& map) {
  return {{"mean", map.mean()}, {"p95", map.quantile(0.95)}, {"max", map.max()}};
}

std::string to_text(const FlipMap& map) {
  return fmt::format("FLIP {:.3g} on average, {:.3g} at the 95th percentile, {:.3g} at most", map.mean(),
                     map.quantile(0.95), map.max());
}

}  // namespace raysweep
