// Predicts, measures and times what a scene can be rendered with.
#pragma once

#include <string>
#include <vector>

#include "experiments/advise/advice.h"
#include "experiments/advise/time_rounds.h"
#include "tracer/settings.h"

namespace raysweep {

struct AdviceRequest {
  RenderSettings
      settings;  // of the pictures that are timed; their method and precision are what is asked for
  double tolerance = default_hit_tolerance;
  RoundOptions rounds;
};

/// A method of the study that cannot be rendered with: evidence beside the advice.
struct StudyLine {
  MethodChoice choice;
  double bound = 0;                 // as `Prediction::bound`
  Measurement measured;             // its error as a share of the scene's size
  std::vector<double> nanoseconds;  // a test of a hit, by its kernel alone
};

struct Advice {
  std::string scene, core;
  size_t triangles = 0, predicted_hits = 0, measured_hits = 0;
  double size = 0, tolerance = 0;
  HitNumbers numbers;
  std::vector<Advised> all;
  Ranking ranking;
  std::vector<StudyLine> study;  // all methods of the study, the tracer's too; empty without hits
};

/// Predicts from one sample of the scene's rays, measures on another, and times pictures in one thread.
[[nodiscard]] Advice advise(const Scene& scene, const AdviceRequest& request);

/// What `render` takes: the first of `choices_by_cost` whose prediction keeps `tolerance`; only those of
/// `precision` where that is not empty. Depends on the scene alone, not on times. Throws RequestError with
/// the smallest tolerance that can be promised where none does.
[[nodiscard]] Prediction choose_method(const Scene& scene, std::string_view core, std::string_view precision,
                                       double tolerance);

}  // namespace raysweep
