// What `raysweep render` tells of the picture that it made.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "experiments/render_job.h"
#include "tracer/compare.h"

namespace raysweep {

/// Why the method "auto" became what it is.
struct ChosenMethod {
  double bound = 0, tolerance = 0;  // of hit points, as shares of the scene's size
};

struct RenderOutcome {
  std::string out;
  int frames = 1;
  double seconds = 0;                           // of all frames
  std::optional<PictureDifference> difference;  // from the reference, where one was given
  std::optional<ChosenMethod> chosen;           // of the method "auto"
};

/// All of it, as one JSON document.
[[nodiscard]] nlohmann::json describe(const Cell& cell, const RenderJob& job, const RenderOutcome& outcome);

/// The same in a few lines for people.
void print_outcome(const Cell& cell, const RenderJob& job, const RenderOutcome& outcome);

}  // namespace raysweep
